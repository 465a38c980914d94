package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.BoundingBox;

/**
 * Axis-aligned rectangle on the ground.
 *
 * @param minX minimum x in metres
 * @param maxX maximum x in metres
 * @param minY minimum y in metres
 * @param maxY maximum y in metres
 */
record Area(double minX, double maxX, double minY, double maxY) {

    boolean contains(Vector3 point) {
        return point.x() >= minX && point.x() <= maxX && point.y() >= minY && point.y() <= maxY;
    }

    boolean touches(BoundingBox box) {
        return box.max().x() >= minX
                && box.min().x() <= maxX
                && box.max().y() >= minY
                && box.min().y() <= maxY;
    }
}
