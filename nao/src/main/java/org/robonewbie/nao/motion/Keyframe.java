package org.robonewbie.nao.motion;

/**
 * One step of a motion: a posture and the time that the robot takes to get there from the posture before.
 *
 * @param durationMillis time of the way to this posture in milliseconds; a robot plays it in whole cycles of 20 ms and takes at
 *     least one cycle
 * @param posture the angles of all joints at the end of the way
 */
public record Keyframe(int durationMillis, Posture posture) {}
