/**
 * What a robot's camera recognises: landmarks, ball, players and lines as SimSpark's vision perceptor reports them, with its
 * noise. Read {@link org.robonewbie.simulator.sensing.Camera} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.sensing;
