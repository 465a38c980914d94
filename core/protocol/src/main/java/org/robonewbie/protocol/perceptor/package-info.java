/**
 * The sensor readings that the simulator sends to an agent in each cycle. Read {@link
 * org.robonewbie.protocol.perceptor.PerceptorMessage} first.
 *
 * <p>Values are in the units and frames of the protocol: metres, degrees and newtons; torso and foot frames have x to the robot's
 * right, y forward and z up.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.perceptor;
