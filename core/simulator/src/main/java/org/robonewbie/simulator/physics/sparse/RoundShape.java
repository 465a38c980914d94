package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.simulator.physics.ode.OdeCollisions;

/** Capsule along the z axis; a sphere is a capsule of length 0. */
final class RoundShape extends CollisionShape {

    private final double radius;
    private final double halfLength;

    RoundShape(
            double radius,
            double halfLength,
            SparseCollider collider,
            double[] position,
            double[] rotation,
            OdeCollisions.Geometry odeGeometry) {
        super(collider, position, rotation, odeGeometry);
        this.radius = radius;
        this.halfLength = halfLength;
    }

    @Override
    double halfExtent(int axis) {
        return radius + Math.abs(rotation[3 * axis + 2]) * halfLength;
    }

    @Override
    int collideWithGround(double[] points) {
        double downwards = rotation[8] > 0 ? -halfLength : halfLength;
        int count = addEnd(points, 0, downwards);
        return halfLength > 0 && count > 0 ? count + addEnd(points, 1, -downwards) : count;
    }

    private int addEnd(double[] points, int index, double along) {
        double z = position[2] + along * rotation[8];
        double depth = radius - z;
        if (depth < 0) {
            return 0;
        }
        setGroundPoint(
                points, index, position[0] + along * rotation[2], position[1] + along * rotation[5], z - radius, depth);
        return 1;
    }
}
