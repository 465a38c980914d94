package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.Robot;

/**
 * Oriented bounding box with a separating axis test.
 *
 * <p>As in SimSpark ({@code boxcollider.cpp}), the cross products of two edges are not normalised. Nearly parallel
 * edges yield an axis of nearly zero length, along which the boxes count as separated. Boxes that are rotated relative
 * to each other about a single common axis therefore never overlap.
 *
 * @param centre centre in the world frame
 * @param x half of the edge along the box's x axis, as a vector in the world frame
 * @param y half of the edge along the box's y axis, as a vector in the world frame
 * @param z half of the edge along the box's z axis, as a vector in the world frame
 */
record OrientedBox(Vector3 centre, Vector3 x, Vector3 y, Vector3 z) {

    static OrientedBox of(Robot robot, int link) {
        Shape.Box box = (Shape.Box) robot.nao().links().get(link).shape();
        BodyPose pose = robot.linkPose(link);
        return new OrientedBox(
                pose.position(),
                pose.rotation().axisX().times(box.size().x() / 2),
                pose.rotation().axisY().times(box.size().y() / 2),
                pose.rotation().axisZ().times(box.size().z() / 2));
    }

    boolean overlaps(OrientedBox other, double tolerance) {
        if (centre.distanceTo(other.centre) + tolerance > radius() + other.radius()) {
            return false;
        }
        Vector3[] axes = unitAxes();
        Vector3[] otherAxes = other.unitAxes();
        for (int i = 0; i < 3; i++) {
            if (isSeparated(other, axes[i], tolerance) || isSeparated(other, otherAxes[i], tolerance)) {
                return false;
            }
        }
        for (Vector3 axis : axes) {
            for (Vector3 otherAxis : otherAxes) {
                if (isSeparated(other, axis.cross(otherAxis), tolerance)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean isSeparated(OrientedBox other, Vector3 axis, double tolerance) {
        double distance = Math.abs(other.centre.minus(centre).dot(axis));
        return distance + tolerance > extent(axis) + other.extent(axis);
    }

    private double extent(Vector3 axis) {
        return Math.abs(x.dot(axis)) + Math.abs(y.dot(axis)) + Math.abs(z.dot(axis));
    }

    private double radius() {
        return Math.sqrt(x.dot(x) + y.dot(y) + z.dot(z));
    }

    private Vector3[] unitAxes() {
        return new Vector3[] {x.times(1 / x.length()), y.times(1 / y.length()), z.times(1 / z.length())};
    }
}
