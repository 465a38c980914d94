package org.robonewbie.nao.model;

import org.robonewbie.nao.Vector3;

/**
 * A rigid body of the robot.
 *
 * @param name SimSpark's name for the body, such as {@code rthigh}; unique within the robot
 * @param shape collision shape
 * @param massKg mass in kilograms
 * @param position centre of the body relative to the torso's centre in the construction pose, in SimSpark's frame: x right, y
 *     forward, z up, in metres
 * @param collides whether the body collides with others; false for the small spheres inside the joints
 */
public record Link(String name, Shape shape, double massKg, Vector3 position, boolean collides) {}
