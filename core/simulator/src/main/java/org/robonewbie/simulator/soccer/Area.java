package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.BoundingBox;

/**
 * A rectangle on the ground along the field lines.
 *
 * @param minX smallest x, metres
 * @param maxX greatest x, metres
 * @param minY smallest y, metres
 * @param maxY greatest y, metres
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
