/**
 * What a robot's camera recognises: landmarks, ball, players and lines as SimSpark's vision perceptor reports them, with its
 * noise. Read {@link org.robonewbie.simulator.sensing.Camera} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.sensing;
