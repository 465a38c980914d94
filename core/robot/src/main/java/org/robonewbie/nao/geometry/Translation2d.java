package org.robonewbie.nao.geometry;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * A point on the ground, or the displacement between two points. In a team's frame the origin is the centre spot, x points to
 * the opponents' goal and y to the left. In a robot's frame x points forward and y to the left.
 *
 * @param x first component in metres
 * @param y second component in metres
 */
public record Translation2d(double x, double y) {

    /** The origin of the frame: the centre spot in a team's frame, the robot in its own. */
    public static final Translation2d ORIGIN = new Translation2d(0, 0);

    /**
     * Projects a point onto the ground.
     *
     * @param point a point in space, in metres
     * @return the point on the ground below it
     */
    public static Translation2d of(Vector3 point) {
        return new Translation2d(point.x(), point.y());
    }

    /**
     * Creates a translation from polar coordinates.
     *
     * @param degrees direction in degrees, 0 along x, positive to the left
     * @param metres length in metres
     * @return the translation
     */
    public static Translation2d polar(double degrees, double metres) {
        double angle = PortableMath.toRadians(degrees);
        return new Translation2d(metres * PortableMath.cos(angle), metres * PortableMath.sin(angle));
    }

    /**
     * Returns the sum of this translation and another one.
     *
     * @param other the translation to add
     * @return this + other
     */
    public Translation2d plus(Translation2d other) {
        return new Translation2d(x + other.x, y + other.y);
    }

    /**
     * Returns the difference between this translation and another one.
     *
     * @param other the translation to subtract
     * @return this - other, the displacement from the other point to this one
     */
    public Translation2d minus(Translation2d other) {
        return new Translation2d(x - other.x, y - other.y);
    }

    /**
     * Returns this translation scaled by a factor.
     *
     * @param factor the factor for both components
     * @return factor * this
     */
    public Translation2d times(double factor) {
        return new Translation2d(factor * x, factor * y);
    }

    /**
     * Returns the point at the given distance from this one, in the direction of another point.
     *
     * @param other the point that gives the direction
     * @param metres distance from this point in metres
     * @return the point on the line; this point if both coincide
     */
    public Translation2d towards(Translation2d other, double metres) {
        double distance = distanceTo(other);
        return distance < 1e-6 ? this : plus(other.minus(this).times(metres / distance));
    }

    /**
     * Returns the dot product.
     *
     * @param other the second factor
     * @return the dot product
     */
    public double dot(Translation2d other) {
        return x * other.x + y * other.y;
    }

    /** {@return the length in metres} */
    public double length() {
        return PortableMath.hypot(x, y);
    }

    /**
     * Returns the distance to another point.
     *
     * @param other another point
     * @return the distance in metres
     */
    public double distanceTo(Translation2d other) {
        return PortableMath.hypot(x - other.x, y - other.y);
    }

    /** {@return the direction in degrees, 0 along x, positive to the left} */
    public double degrees() {
        return Angles.atan2(y, x);
    }

    /**
     * Returns the distance from this point to a line segment.
     *
     * @param from start of the segment
     * @param to end of the segment
     * @return distance to the nearest point of the segment in metres
     */
    public double distanceToSegment(Translation2d from, Translation2d to) {
        Translation2d segment = to.minus(from);
        double square = segment.dot(segment);
        double fraction = square < 1e-9 ? 0 : minus(from).dot(segment) / square;
        return distanceTo(from.plus(segment.times(Math.max(0, Math.min(1, fraction)))));
    }

    /**
     * Transforms this point from the frame of the pitch to that of a robot.
     *
     * @param pose the robot's pose on the pitch
     * @return the point relative to the robot, x forward and y to the left
     */
    public Translation2d seenFrom(Pose2d pose) {
        return of(pose.fromFrame(vector()));
    }

    /**
     * Transforms this point from the frame of a robot to that of the pitch.
     *
     * @param pose the robot's pose on the pitch
     * @return the point in the frame of the pitch
     */
    public Translation2d onMap(Pose2d pose) {
        return of(pose.toFrame(vector()));
    }

    /** {@return this point in space, at height 0} */
    public Vector3 vector() {
        return new Vector3(x, y, 0);
    }
}
