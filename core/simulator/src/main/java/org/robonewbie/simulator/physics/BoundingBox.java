package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;

/**
 * Axis-aligned bounding box in the world frame.
 *
 * @param min minimum corner in metres
 * @param max maximum corner in metres
 */
public record BoundingBox(Vector3 min, Vector3 max) {

    /**
     * Computes the bounding box of a shape.
     *
     * @param shape the shape
     * @param pose pose of the shape's centre
     * @return its bounding box
     */
    public static BoundingBox of(Shape shape, BodyPose pose) {
        Vector3 half = halfExtents(shape, pose.rotation());
        return new BoundingBox(pose.position().minus(half), pose.position().plus(half));
    }

    /**
     * Combines two boxes.
     *
     * @param other another box
     * @return the bounding box of both
     */
    public BoundingBox union(BoundingBox other) {
        return new BoundingBox(
                new Vector3(
                        Math.min(min.x(), other.min.x()),
                        Math.min(min.y(), other.min.y()),
                        Math.min(min.z(), other.min.z())),
                new Vector3(
                        Math.max(max.x(), other.max.x()),
                        Math.max(max.y(), other.max.y()),
                        Math.max(max.z(), other.max.z())));
    }

    private static Vector3 halfExtents(Shape shape, RotationMatrix rotation) {
        if (shape instanceof Shape.Box box) {
            Vector3 half = box.size().times(0.5);
            return new Vector3(
                    Math.abs(rotation.xx()) * half.x()
                            + Math.abs(rotation.xy()) * half.y()
                            + Math.abs(rotation.xz()) * half.z(),
                    Math.abs(rotation.yx()) * half.x()
                            + Math.abs(rotation.yy()) * half.y()
                            + Math.abs(rotation.yz()) * half.z(),
                    Math.abs(rotation.zx()) * half.x()
                            + Math.abs(rotation.zy()) * half.y()
                            + Math.abs(rotation.zz()) * half.z());
        }
        if (shape instanceof Shape.Sphere sphere) {
            return new Vector3(sphere.radius(), sphere.radius(), sphere.radius());
        }
        Shape.Capsule capsule = (Shape.Capsule) shape;
        double half = capsule.length() / 2;
        return new Vector3(
                capsule.radius() + Math.abs(rotation.xz()) * half,
                capsule.radius() + Math.abs(rotation.yz()) * half,
                capsule.radius() + Math.abs(rotation.zz()) * half);
    }
}
