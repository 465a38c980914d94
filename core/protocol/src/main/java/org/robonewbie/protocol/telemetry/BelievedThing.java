package org.robonewbie.protocol.telemetry;

import org.robonewbie.nao.Vector3;

/**
 * A robot's belief about the position of one object.
 *
 * @param name what it is: {@code ball}, a landmark such as {@code GOAL_POST_1_LEFT}, or a robot as {@code TEAM NUMBER}
 * @param position metres from the centre of the robot's head along the axes of its torso: x forward, y left, z up
 * @param ageSeconds seconds since it was last seen
 * @param visible whether it was in the last picture of the camera
 */
public record BelievedThing(String name, Vector3 position, double ageSeconds, boolean visible) {}
