package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;

/** Group of moving shapes that do not collide with each other, with a common bounding box. */
final class ShapeGroup {

    private final List<CollisionShape> shapes = new ArrayList<>();
    private final double[] min = new double[3];
    private final double[] max = new double[3];

    void add(CollisionShape shape) {
        shapes.add(shape);
    }

    List<CollisionShape> shapes() {
        return shapes;
    }

    void updateBounds() {
        for (int axis = 0; axis < 3; axis++) {
            min[axis] = Double.POSITIVE_INFINITY;
            max[axis] = Double.NEGATIVE_INFINITY;
        }
        for (int i = 0; i < shapes.size(); i++) {
            CollisionShape shape = shapes.get(i);
            shape.updateBounds();
            for (int axis = 0; axis < 3; axis++) {
                min[axis] = Math.min(min[axis], shape.min[axis]);
                max[axis] = Math.max(max[axis], shape.max[axis]);
            }
        }
    }

    boolean overlaps(ShapeGroup other) {
        return overlap(min, max, other.min, other.max);
    }

    boolean overlaps(CollisionShape shape) {
        return overlap(min, max, shape.min, shape.max);
    }

    private static boolean overlap(double[] min, double[] max, double[] otherMin, double[] otherMax) {
        for (int axis = 0; axis < 3; axis++) {
            if (!(min[axis] <= otherMax[axis] && otherMin[axis] <= max[axis])) {
                return false;
            }
        }
        return true;
    }
}
