package org.robonewbie.nao.geometry;

import org.robonewbie.nao.math.PortableMath;

/** Arithmetic of angles in degrees. */
public final class Angles {

    private Angles() {}

    /**
     * Wraps an angle to one turn.
     *
     * @param degrees any angle
     * @return the same direction, -180 to 180 degrees
     */
    public static double wrap(double degrees) {
        return PortableMath.IEEEremainder(degrees, 360);
    }

    /**
     * Direction of a vector.
     *
     * @param y its part to the left
     * @param x its part ahead
     * @return degrees from the x axis, positive to the left, -180 to 180
     */
    public static double atan2(double y, double x) {
        return PortableMath.toDegrees(PortableMath.atan2(y, x));
    }
}
