package org.robonewbie.trial;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * Where a robot stands on the pitch and which way it faces.
 *
 * @param x metres from the centre towards the right goal
 * @param y metres from the centre to the left when facing the right goal
 * @param degrees heading: 0 faces the right goal, positive is left
 */
public record Place(double x, double y, double degrees) {

    /**
     * Calculates a point as seen from here.
     *
     * @param distance metres from here
     * @param bearing degrees to the left of the heading
     * @param height metres above the ground
     * @return the point on the pitch
     */
    public Vector3 point(double distance, double bearing, double height) {
        double angle = PortableMath.toRadians(degrees + bearing);
        return new Vector3(x + distance * PortableMath.cos(angle), y + distance * PortableMath.sin(angle), height);
    }

    /**
     * Calculates the point that lies ahead and to the left of here.
     *
     * @param ahead metres along the heading
     * @param left metres to the left of it
     * @return the point on the ground
     */
    public Vector3 pointAt(double ahead, double left) {
        return point(PortableMath.hypot(ahead, left), PortableMath.toDegrees(PortableMath.atan2(left, ahead)), 0);
    }

    /**
     * Calculates the direction of a point as seen from here.
     *
     * @param point a point on the pitch
     * @return degrees to the left of the heading, -180 to 180
     */
    public double bearing(Vector3 point) {
        double direction = PortableMath.toDegrees(PortableMath.atan2(point.y() - y, point.x() - x));
        return PortableMath.IEEEremainder(direction - degrees, 360);
    }

    /**
     * Calculates the distance to a point.
     *
     * @param point a point on the pitch
     * @return metres along the ground
     */
    public double distance(Vector3 point) {
        return PortableMath.hypot(point.x() - x, point.y() - y);
    }

    /**
     * Calculates the distance of a point ahead of here.
     *
     * @param point a point on the pitch
     * @return metres along the heading, negative behind
     */
    public double ahead(Vector3 point) {
        double angle = PortableMath.toRadians(degrees);
        return PortableMath.cos(angle) * (point.x() - x) + PortableMath.sin(angle) * (point.y() - y);
    }

    /**
     * Calculates the distance of a point to the left of here.
     *
     * @param point a point on the pitch
     * @return metres across the heading, negative to the right
     */
    public double left(Vector3 point) {
        double angle = PortableMath.toRadians(degrees);
        return PortableMath.cos(angle) * (point.y() - y) - PortableMath.sin(angle) * (point.x() - x);
    }
}
