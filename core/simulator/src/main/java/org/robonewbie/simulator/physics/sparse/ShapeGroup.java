package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;

/** Moving shapes that never touch each other, with the box around all of them. */
final class ShapeGroup {

    private final List<CollisionShape> shapes = new ArrayList<>();
    private final double[] low = new double[3];
    private final double[] high = new double[3];

    void add(CollisionShape shape) {
        shapes.add(shape);
    }

    List<CollisionShape> shapes() {
        return shapes;
    }

    void measure() {
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
        }
        for (int i = 0; i < shapes.size(); i++) {
            CollisionShape shape = shapes.get(i);
            shape.measure();
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], shape.low[axis]);
                high[axis] = Math.max(high[axis], shape.high[axis]);
            }
        }
    }

    boolean isNear(ShapeGroup other) {
        return overlap(low, high, other.low, other.high);
    }

    boolean isNear(CollisionShape shape) {
        return overlap(low, high, shape.low, shape.high);
    }

    private static boolean overlap(double[] low, double[] high, double[] otherLow, double[] otherHigh) {
        for (int axis = 0; axis < 3; axis++) {
            if (!(low[axis] <= otherHigh[axis] && otherLow[axis] <= high[axis])) {
                return false;
            }
        }
        return true;
    }
}
