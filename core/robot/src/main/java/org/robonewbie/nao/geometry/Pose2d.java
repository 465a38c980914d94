package org.robonewbie.nao.geometry;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * A position on the ground and a heading, in a frame with x forward and y to the left. In the world frame x points to the
 * right goal. In a team's frame the origin is the centre spot and x points to the opponents' goal.
 *
 * @param x first coordinate in metres
 * @param y second coordinate in metres
 * @param degrees heading relative to the x axis in degrees, positive to the left
 */
public record Pose2d(double x, double y, double degrees) {

    /** The origin, facing along x. */
    public static final Pose2d ORIGIN = new Pose2d(0, 0, 0);

    /** {@return the position without the heading} */
    public Translation2d translation() {
        return new Translation2d(x, y);
    }

    /**
     * Transforms a point from coordinates relative to this pose to the frame in which this pose is given.
     *
     * @param seen point relative to this pose, x forward and y to the left, in metres; z is kept
     * @return the same point in the frame in which this pose is given
     */
    public Vector3 toFrame(Vector3 seen) {
        double heading = PortableMath.toRadians(degrees);
        double cos = PortableMath.cos(heading);
        double sin = PortableMath.sin(heading);
        return new Vector3(x + cos * seen.x() - sin * seen.y(), y + sin * seen.x() + cos * seen.y(), seen.z());
    }

    /**
     * Transforms a point to coordinates relative to this pose.
     *
     * @param point point in the frame in which this pose is given, in metres; z is kept
     * @return the same point relative to this pose, x forward and y to the left
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
     * Returns the pose after a move along this pose's own axes and a turn. The heading is not wrapped.
     *
     * @param forward distance forward in metres
     * @param left distance to the left in metres
     * @param turnDegrees turn to the left after the move, in degrees
     * @return the new pose in the same frame
     */
    public Pose2d then(double forward, double left, double turnDegrees) {
        double heading = PortableMath.toRadians(degrees);
        double cos = PortableMath.cos(heading);
        double sin = PortableMath.sin(heading);
        return new Pose2d(x + (cos * forward - sin * left), y + (sin * forward + cos * left), degrees + turnDegrees);
    }

    /**
     * Interpolates position and heading linearly. The heading is not wrapped.
     *
     * @param end the other pose
     * @param fraction 0 for this pose, 1 for the other
     * @return the interpolated pose
     */
    public Pose2d interpolate(Pose2d end, double fraction) {
        return new Pose2d(
                x + fraction * (end.x - x), y + fraction * (end.y - y), degrees + fraction * (end.degrees - degrees));
    }

    /**
     * Returns the point with the given polar coordinates relative to this pose.
     *
     * @param distance distance along the ground in metres
     * @param bearing angle to the left of the heading in degrees
     * @param height height above the ground in metres
     * @return the point in the frame in which this pose is given
     */
    public Vector3 point(double distance, double bearing, double height) {
        double angle = PortableMath.toRadians(degrees + bearing);
        return new Vector3(x + distance * PortableMath.cos(angle), y + distance * PortableMath.sin(angle), height);
    }

    /**
     * Returns the point on the ground with the given coordinates relative to this pose.
     *
     * @param ahead distance along the heading in metres
     * @param left distance to the left of the heading in metres
     * @return the point in the frame in which this pose is given
     */
    public Vector3 pointAt(double ahead, double left) {
        return point(PortableMath.hypot(ahead, left), Angles.atan2(left, ahead), 0);
    }

    /**
     * Returns the bearing of a point.
     *
     * @param point a point in the frame in which this pose is given
     * @return angle to the left of the heading in degrees, -180 to 180
     */
    public double bearing(Vector3 point) {
        return Angles.wrap(Angles.atan2(point.y() - y, point.x() - x) - degrees);
    }

    /**
     * Returns the distance to a point.
     *
     * @param point a point in the frame in which this pose is given
     * @return distance along the ground in metres
     */
    public double distance(Vector3 point) {
        return PortableMath.hypot(point.x() - x, point.y() - y);
    }

    /**
     * Returns how far a point is in front of this pose.
     *
     * @param point a point in the frame in which this pose is given
     * @return distance along the heading in metres, negative behind
     */
    public double ahead(Vector3 point) {
        return fromFrame(point).x();
    }

    /**
     * Returns how far a point is to the left of this pose.
     *
     * @param point a point in the frame in which this pose is given
     * @return distance perpendicular to the heading in metres, negative to the right
     */
    public double left(Vector3 point) {
        return fromFrame(point).y();
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, "(%.2f, %.2f) facing %.1f degrees", x, y, degrees);
    }
}
