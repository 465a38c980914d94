package org.robonewbie.nao.geometry;

import org.robonewbie.nao.math.PortableMath;

/** Arithmetic with angles in degrees. */
public final class Angles {

    private Angles() {}

    /**
     * Wraps an angle to the range from -180 to 180 degrees.
     *
     * @param degrees any angle
     * @return the equivalent angle, -180 to 180 degrees
     */
    public static double wrap(double degrees) {
        return PortableMath.IEEEremainder(degrees, 360);
    }

    /**
     * Returns the direction of a vector.
     *
     * @param y component to the left
     * @param x component forward
     * @return angle from the x axis in degrees, positive to the left, -180 to 180
     */
    public static double atan2(double y, double x) {
        return PortableMath.toDegrees(PortableMath.atan2(y, x));
    }
}
