package org.robonewbie.nao.motion;

/**
 * One step of a motion: a posture and the time to reach it from the previous one.
 *
 * @param durationMillis time to reach the posture in milliseconds; played in whole cycles of 20 ms, at least one
 * @param posture the angles of all joints at the end of the step
 */
public record Keyframe(int durationMillis, Posture posture) {}
