package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;

/**
 * The smallest box along the world's axes that holds something.
 *
 * @param min the corner with the smallest coordinates, metres
 * @param max the corner with the largest coordinates, metres
 */
public record BoundingBox(Vector3 min, Vector3 max) {

    /**
     * Measures a shape in a pose.
     *
     * @param shape the shape
     * @param pose where its centre is and how it is turned
     * @return the box around it
     */
    public static BoundingBox of(Shape shape, BodyPose pose) {
        Vector3 half = halfExtents(shape, pose.rotation());
        return new BoundingBox(pose.position().minus(half), pose.position().plus(half));
    }

    /**
     * Widens this box until it holds another one.
     *
     * @param other the other box
     * @return the smallest box around both
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

    private static Vector3 halfExtents(Shape shape, RotationMatrix turn) {
        if (shape instanceof Shape.Box box) {
            Vector3 half = box.size().times(0.5);
            return new Vector3(
                    Math.abs(turn.xx()) * half.x() + Math.abs(turn.xy()) * half.y() + Math.abs(turn.xz()) * half.z(),
                    Math.abs(turn.yx()) * half.x() + Math.abs(turn.yy()) * half.y() + Math.abs(turn.yz()) * half.z(),
                    Math.abs(turn.zx()) * half.x() + Math.abs(turn.zy()) * half.y() + Math.abs(turn.zz()) * half.z());
        }
        if (shape instanceof Shape.Sphere sphere) {
            return new Vector3(sphere.radius(), sphere.radius(), sphere.radius());
        }
        Shape.Capsule capsule = (Shape.Capsule) shape;
        double half = capsule.length() / 2;
        return new Vector3(
                capsule.radius() + Math.abs(turn.xz()) * half,
                capsule.radius() + Math.abs(turn.yz()) * half,
                capsule.radius() + Math.abs(turn.zz()) * half);
    }
}
