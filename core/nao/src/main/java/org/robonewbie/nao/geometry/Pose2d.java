package org.robonewbie.nao.geometry;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * A place on the ground and a heading, in a frame with x forward and y to the left. In the world frame x points to the right goal;
 * in the coordinates of a team the origin is the centre spot and x points to the opponents' goal.
 *
 * @param x metres
 * @param y metres
 * @param degrees heading against the x axis; positive is left
 */
public record Pose2d(double x, double y, double degrees) {

    /** At the origin, facing along x. */
    public static final Pose2d ORIGIN = new Pose2d(0, 0, 0);

    /** {@return the place without the heading} */
    public Translation2d translation() {
        return new Translation2d(x, y);
    }

    /**
     * Converts a point that was seen from here.
     *
     * @param seen x forward, y left of this pose, in metres; the height stays
     * @return the same point in the frame of this pose
     */
    public Vector3 toFrame(Vector3 seen) {
        double heading = PortableMath.toRadians(degrees);
        double cos = PortableMath.cos(heading);
        double sin = PortableMath.sin(heading);
        return new Vector3(x + cos * seen.x() - sin * seen.y(), y + sin * seen.x() + cos * seen.y(), seen.z());
    }

    /**
     * Converts a point to the view from here.
     *
     * @param point a point in the frame of this pose, in metres; the height stays
     * @return x forward, y left of this pose
     */
    public Vector3 fromFrame(Vector3 point) {
        double heading = PortableMath.toRadians(degrees);
        double cos = PortableMath.cos(heading);
        double sin = PortableMath.sin(heading);
        double dx = point.x() - x;
        double dy = point.y() - y;
        return new Vector3(cos * dx + sin * dy, cos * dy - sin * dx, point.z());
    }

    /**
     * Moves along the own axes and then turns. The heading is not wrapped.
     *
     * @param forward metres ahead
     * @param left metres to the left
     * @param turnDegrees turn to the left after that
     * @return the new pose in the same frame
     */
    public Pose2d then(double forward, double left, double turnDegrees) {
        double heading = PortableMath.toRadians(degrees);
        double cos = PortableMath.cos(heading);
        double sin = PortableMath.sin(heading);
        return new Pose2d(x + (cos * forward - sin * left), y + (sin * forward + cos * left), degrees + turnDegrees);
    }

    /**
     * Interpolates place and heading linearly. The heading is not wrapped.
     *
     * @param end the other pose
     * @param fraction 0 for this pose, 1 for the other
     * @return the pose between
     */
    public Pose2d interpolate(Pose2d end, double fraction) {
        return new Pose2d(
                x + fraction * (end.x - x), y + fraction * (end.y - y), degrees + fraction * (end.degrees - degrees));
    }

    /**
     * Returns a point by its polar coordinates.
     *
     * @param distance metres from here
     * @param bearing degrees to the left of the heading
     * @param height metres above the ground
     * @return the point in the frame of this pose
     */
    public Vector3 point(double distance, double bearing, double height) {
        double angle = PortableMath.toRadians(degrees + bearing);
        return new Vector3(x + distance * PortableMath.cos(angle), y + distance * PortableMath.sin(angle), height);
    }

    /**
     * Returns the point that lies ahead and to the left.
     *
     * @param ahead metres along the heading
     * @param left metres to the left of it
     * @return the point on the ground
     */
    public Vector3 pointAt(double ahead, double left) {
        return point(PortableMath.hypot(ahead, left), Angles.atan2(left, ahead), 0);
    }

    /**
     * Direction of a point as seen from here.
     *
     * @param point a point in the frame of this pose
     * @return degrees to the left of the heading, -180 to 180
     */
    public double bearing(Vector3 point) {
        return Angles.wrap(Angles.atan2(point.y() - y, point.x() - x) - degrees);
    }

    /**
     * Distance to a point.
     *
     * @param point a point in the frame of this pose
     * @return metres along the ground
     */
    public double distance(Vector3 point) {
        return PortableMath.hypot(point.x() - x, point.y() - y);
    }

    /**
     * Distance of a point along the heading.
     *
     * @param point a point in the frame of this pose
     * @return metres, negative behind
     */
    public double ahead(Vector3 point) {
        return fromFrame(point).x();
    }

    /**
     * Distance of a point across the heading.
     *
     * @param point a point in the frame of this pose
     * @return metres, negative to the right
     */
    public double left(Vector3 point) {
        return fromFrame(point).y();
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, "(%.2f, %.2f) facing %.1f degrees", x, y, degrees);
    }
}
