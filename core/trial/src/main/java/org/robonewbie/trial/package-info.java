/**
 * Deterministic trials, measured from the ground truth; exercises, contests, learning and experiments are based on
 * them. Read {@link org.robonewbie.trial.Trial} first. An example that measures a motion:
 *
 * <pre>{@code
 * Scene scene = Scene.of(RobotStart.at(-3, 0).after(stand)).withBall(-2.8, 0.04);
 * try (Trial trial = Trial.direct(scene, seed, Controller.ofMotion(motion))) {
 *     Measure kick = new KickDistance();
 *     trial.run(10, kick, new Upright());
 *     return kick.value();
 * }
 * }</pre>
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial;
