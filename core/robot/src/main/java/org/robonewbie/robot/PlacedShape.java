package org.robonewbie.robot;

import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.Shape;

/**
 * A solid shape of a body.
 *
 * @param shape the shape
 * @param pose its centre and orientation in the body's frame
 * @param collides whether it collides with other bodies; false for a shape that is only drawn
 */
public record PlacedShape(Shape shape, Pose pose, boolean collides) {}
