package org.robonewbie.nao.model;

import org.robonewbie.nao.Vector3;

/**
 * One rigid body of the robot.
 *
 * @param name SimSpark's name of the body, such as {@code rthigh}; unique within the robot
 * @param shape its collision shape
 * @param massKg its mass in kilograms
 * @param position its centre relative to the torso's centre in the construction pose, in SimSpark's frame: x right, y forward,
 *     z up, in metres
 * @param collides whether it collides with other bodies; the small spheres inside the joints do not
 */
public record Link(String name, Shape shape, double massKg, Vector3 position, boolean collides) {}
