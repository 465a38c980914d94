package org.robonewbie.nao.motion;

/**
 * One step of a motion: a posture and the time that the robot takes to get there from the previous one.
 *
 * @param durationMillis time to reach this posture in milliseconds; a robot plays it in whole cycles of 20 ms and takes at
 *     least one cycle
 * @param posture the angles of all joints at the end of the step
 */
public record Keyframe(int durationMillis, Posture posture) {}
