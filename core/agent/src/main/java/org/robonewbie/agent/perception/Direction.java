package org.robonewbie.agent.perception;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.math.PortableMath;

/**
 * Polar coordinates of an object, as seen by a robot looking straight ahead.
 *
 * @param distance distance from the centre of the head, in metres
 * @param bearing horizontal angle from the torso's forward direction in degrees; positive is left
 * @param elevation angle in degrees above the plane of the torso's forward and left axes; positive is up
 */
public record Direction(double distance, double bearing, double elevation) {

    /**
     * Converts a point to polar coordinates.
     *
     * @param point x forward, y left, z up, relative to the centre of the head, in metres
     * @return its direction
     */
    public static Direction of(Vector3 point) {
        return new Direction(
                point.length(),
                Angles.atan2(point.y(), point.x()),
                Angles.atan2(point.z(), PortableMath.hypot(point.x(), point.y())));
    }

    /**
     * Converts the direction to a point.
     *
     * @return x forward, y left, z up, relative to the centre of the head, in metres
     */
    public Vector3 toPoint() {
        double b = PortableMath.toRadians(bearing);
        double e = PortableMath.toRadians(elevation);
        return new Vector3(
                        PortableMath.cos(b) * PortableMath.cos(e),
                        PortableMath.sin(b) * PortableMath.cos(e),
                        PortableMath.sin(e))
                .times(distance);
    }

    /** {@return the horizontal distance from the head, in metres} */
    public double distanceOnGround() {
        return distance * PortableMath.cos(PortableMath.toRadians(elevation));
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "%.2f m, %.1f degrees %s, %.1f degrees %s",
                distance,
                Math.abs(bearing),
                bearing < 0 ? "right" : "left",
                Math.abs(elevation),
                elevation < 0 ? "down" : "up");
    }
}
