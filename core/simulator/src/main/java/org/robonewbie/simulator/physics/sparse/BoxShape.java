package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

final class BoxShape extends CollisionShape {

    private final double[] half;
    private final double[] drop = new double[3];
    private final double[] corner = new double[3];

    BoxShape(
            Shape.Box box,
            SparseCollider collider,
            double[] position,
            double[] rotation,
            OdeCollisions.Geometry odeGeometry) {
        super(collider, position, rotation, odeGeometry);
        half = new double[] {box.size().x() / 2, box.size().y() / 2, box.size().z() / 2};
    }

    @Override
    double halfExtent(int axis) {
        return Math.abs(rotation[3 * axis] * half[0])
                + Math.abs(rotation[3 * axis + 1] * half[1])
                + Math.abs(rotation[3 * axis + 2] * half[2]);
    }

    /**
     * Returns the deepest corner, its neighbours along the two edges that are closest to horizontal, and the corner between
     * those (ODE: {@code dCollideBoxPlane}).
     */
    @Override
    int collideWithGround(double[] points) {
        for (int edge = 0; edge < 3; edge++) {
            drop[edge] = 2 * half[edge] * rotation[6 + edge];
        }
        double depth = 0.5 * (Math.abs(drop[0]) + Math.abs(drop[1]) + Math.abs(drop[2])) - position[2];
        if (depth < 0) {
            return 0;
        }
        for (int axis = 0; axis < 3; axis++) {
            corner[axis] = position[axis]
                    - signedHalf(0) * rotation[3 * axis]
                    - signedHalf(1) * rotation[3 * axis + 1]
                    - signedHalf(2) * rotation[3 * axis + 2];
        }
        setGroundPoint(points, 0, corner[0], corner[1], corner[2], depth);
        int one = mostHorizontalEdge(-1);
        int two = mostHorizontalEdge(one);
        double depthOne = depth - Math.abs(drop[one]);
        double depthTwo = depth - Math.abs(drop[two]);
        if (depthOne < 0) {
            return 1;
        }
        addCorner(points, 1, 2 * signedHalf(one), one, 0, one, depthOne);
        if (depthTwo < 0) {
            return 2;
        }
        addCorner(points, 2, 2 * signedHalf(two), two, 0, two, depthTwo);
        double depthBoth = depthOne + depthTwo - depth;
        if (depthBoth <= 0) {
            return 3;
        }
        addCorner(points, 3, 2 * signedHalf(one), one, 2 * signedHalf(two), two, depthBoth);
        return 4;
    }

    /** Returns half the length of an edge, signed so that it points upwards. */
    private double signedHalf(int edge) {
        return drop[edge] > 0 ? half[edge] : -half[edge];
    }

    private int mostHorizontalEdge(int except) {
        int best = except == 0 ? 1 : 0;
        for (int edge = best + 1; edge < 3; edge++) {
            if (edge != except && Math.abs(drop[edge]) < Math.abs(drop[best])) {
                best = edge;
            }
        }
        return best;
    }

    private void addCorner(double[] points, int index, double a, int edgeA, double b, int edgeB, double depth) {
        setGroundPoint(
                points,
                index,
                corner[0] + a * rotation[edgeA] + b * rotation[edgeB],
                corner[1] + a * rotation[3 + edgeA] + b * rotation[3 + edgeB],
                corner[2] + a * rotation[6 + edgeA] + b * rotation[6 + edgeB],
                depth);
    }
}
