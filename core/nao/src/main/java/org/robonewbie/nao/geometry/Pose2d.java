package org.robonewbie.nao.geometry;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * A place on the ground and a direction, in a frame with x forward and y to the left.
 *
 * @param x metres forward from the origin
 * @param y metres to the left of the origin
 * @param headingDegrees direction against the frame's x axis; positive is left
 */
public record Pose2d(double x, double y, double headingDegrees) {

    /** At the origin, facing forward. */
    public static final Pose2d ORIGIN = new Pose2d(0, 0, 0);

    /**
     * Moves on.
     *
     * @param forward metres ahead
     * @param left metres to the left
     * @param turnDegrees turn to the left after that
     * @return the new pose in the same frame
     */
    public Pose2d moved(double forward, double left, double turnDegrees) {
        Vector3 place = toFrame(new Vector3(forward, left, 0));
        return new Pose2d(place.x(), place.y(), PortableMath.IEEEremainder(headingDegrees + turnDegrees, 360));
    }

    /**
     * Converts a point that was seen from here.
     *
     * @param seen x forward, y left of this pose, in metres; the height stays
     * @return the same point in the frame of this pose
     */
    public Vector3 toFrame(Vector3 seen) {
        double heading = PortableMath.toRadians(headingDegrees);
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
        double heading = PortableMath.toRadians(headingDegrees);
        double cos = PortableMath.cos(heading);
        double sin = PortableMath.sin(heading);
        double dx = point.x() - x;
        double dy = point.y() - y;
        return new Vector3(cos * dx + sin * dy, cos * dy - sin * dx, point.z());
    }

    /**
     * Goes a part of the way to another pose.
     *
     * @param other where to
     * @param share 0 stays, 1 goes all the way
     * @return the pose between
     */
    public Pose2d towards(Pose2d other, double share) {
        double turn = PortableMath.IEEEremainder(other.headingDegrees - headingDegrees, 360);
        return new Pose2d(
                x + share * (other.x - x),
                y + share * (other.y - y),
                PortableMath.IEEEremainder(headingDegrees + share * turn, 360));
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, "(%.2f, %.2f) facing %.1f degrees", x, y, headingDegrees);
    }
}
