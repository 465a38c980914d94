/**
 * Simulated camera with the noise of SimSpark's vision perceptor: landmarks, ball, players and field lines. Read {@link
 * org.robonewbie.simulator.sensing.Camera} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.sensing;
