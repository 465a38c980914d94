package org.robonewbie.protocol.telemetry;

import org.robonewbie.nao.Vector3;

/**
 * A robot's estimate of the position of an object.
 *
 * @param name name of the object: {@code ball}, a landmark such as {@code GOAL_POST_1_LEFT}, or a robot, written as {@code TEAM
 *     NUMBER}
 * @param position position relative to the centre of the robot's head along the axes of its torso, x forward, y left, z up, in metres
 * @param ageSeconds time in seconds since the object was last seen
 * @param visible whether the object was in the last camera image
 */
public record BelievedThing(String name, Vector3 position, double ageSeconds, boolean visible) {}
