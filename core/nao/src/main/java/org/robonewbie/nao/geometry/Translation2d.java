package org.robonewbie.nao.geometry;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * A point on the ground, or the way from one point to another. In the coordinates of the team, x points to the opponents' goal, y to
 * the left of that, and the origin is the centre spot; seen from a robot, x is ahead and y to its left.
 *
 * @param x metres
 * @param y metres
 */
public record Translation2d(double x, double y) {

    /** The centre spot, or where the robot itself stands. */
    public static final Translation2d ORIGIN = new Translation2d(0, 0);

    /**
     * Forgets the height of a point.
     *
     * @param point in metres
     * @return the point below it
     */
    public static Translation2d of(Vector3 point) {
        return new Translation2d(point.x(), point.y());
    }

    /**
     * Returns the way of a length in a direction.
     *
     * @param degrees 0 is along x, positive turns left
     * @param metres its length
     * @return the way
     */
    public static Translation2d polar(double degrees, double metres) {
        double angle = PortableMath.toRadians(degrees);
        return new Translation2d(metres * PortableMath.cos(angle), metres * PortableMath.sin(angle));
    }

    /**
     * Goes on from here.
     *
     * @param way where to
     * @return the end of the way
     */
    public Translation2d plus(Translation2d way) {
        return new Translation2d(x + way.x, y + way.y);
    }

    /**
     * Returns the way that leads here.
     *
     * @param from where it begins
     * @return the way
     */
    public Translation2d minus(Translation2d from) {
        return new Translation2d(x - from.x, y - from.y);
    }

    /**
     * Stretches the way.
     *
     * @param factor 1 leaves it as it is
     * @return the stretched way
     */
    public Translation2d times(double factor) {
        return new Translation2d(factor * x, factor * y);
    }

    /**
     * Goes a part of the way to another point.
     *
     * @param other where to
     * @param metres how far
     * @return the point between
     */
    public Translation2d towards(Translation2d other, double metres) {
        double distance = distanceTo(other);
        return distance < 1e-6 ? this : plus(other.minus(this).times(metres / distance));
    }

    /**
     * Calculates how long one way is along another.
     *
     * @param other the other way
     * @return the scalar product
     */
    public double dot(Translation2d other) {
        return x * other.x + y * other.y;
    }

    /** {@return the length of the way, metres} */
    public double length() {
        return PortableMath.hypot(x, y);
    }

    /**
     * Calculates a distance.
     *
     * @param other another point
     * @return metres
     */
    public double distanceTo(Translation2d other) {
        return PortableMath.hypot(x - other.x, y - other.y);
    }

    /** {@return the direction of the way in degrees; 0 is along x, positive is left} */
    public double degrees() {
        return Angles.atan2(y, x);
    }

    /**
     * Calculates how near a straight way comes by.
     *
     * @param from where it begins
     * @param to where it ends
     * @return metres from this point to the nearest point of the way
     */
    public double distanceToWay(Translation2d from, Translation2d to) {
        Translation2d way = to.minus(from);
        double square = way.dot(way);
        double share = square < 1e-9 ? 0 : minus(from).dot(way) / square;
        return distanceTo(from.plus(way.times(Math.max(0, Math.min(1, share)))));
    }

    /**
     * Sees this point from a robot.
     *
     * @param pose where the robot stands
     * @return metres ahead and to the left of it
     */
    public Translation2d seenFrom(Pose2d pose) {
        return of(pose.fromFrame(vector()));
    }

    /**
     * Puts what a robot sees on the map.
     *
     * @param pose where the robot stands
     * @return the point in the frame of the pose
     */
    public Translation2d onMap(Pose2d pose) {
        return of(pose.toFrame(vector()));
    }

    /** {@return the same point on the ground} */
    public Vector3 vector() {
        return new Vector3(x, y, 0);
    }
}
