package org.robonewbie.simulator.sensing;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * View cone of a camera in the frame of the head: x right, y forward, z up.
 *
 * <p>Points are tested by their angles. A line that is only partly visible is clipped to the rectangular image instead,
 * so its clipped ends may lie slightly outside the angle limits.
 */
final class ViewCone {

    private static final double MIN_DISTANCE = 0.1;
    private static final double ROUNDING = 1e-9;

    private final double halfHorizontal;
    private final double halfVertical;
    private final double across;
    private final double upward;
    private final Vector3[] sides;
    private final double[] cuts = new double[12];

    ViewCone(double horizontalDegrees, double verticalDegrees) {
        halfHorizontal = PortableMath.toRadians(horizontalDegrees) / 2;
        halfVertical = PortableMath.toRadians(verticalDegrees) / 2;
        across = PortableMath.tan(halfHorizontal);
        upward = PortableMath.tan(halfVertical);
        sides = new Vector3[] {
            new Vector3(1, across, 0), new Vector3(-1, across, 0), new Vector3(0, upward, -1), new Vector3(0, upward, 1)
        };
    }

    /** Returns whether a point is visible. */
    boolean contains(double x, double y, double z) {
        return y > 0
                && Math.sqrt(x * x + y * y + z * z) > MIN_DISTANCE
                && isWithin(x, y, halfHorizontal, across)
                && isWithin(z, PortableMath.hypot(x, y), halfVertical, upward);
    }

    /**
     * Returns whether an angle is within a limit. Unless it is close to the limit, its tangent is compared instead, which
     * is faster.
     */
    private static boolean isWithin(double opposite, double adjacent, double limit, double tangent) {
        double edge = tangent * adjacent;
        if (limit < Math.PI / 2 && Math.abs(Math.abs(opposite) - edge) > ROUNDING * edge) {
            return Math.abs(opposite) < edge;
        }
        return Math.abs(PortableMath.atan2(opposite, adjacent)) <= limit;
    }

    /**
     * Clips a line to its visible part.
     *
     * @param line the coordinates of both ends, modified in place
     * @return whether any part is visible
     */
    boolean clip(double[] line) {
        boolean startVisible = contains(line[0], line[1], line[2]);
        boolean endVisible = contains(line[3], line[4], line[5]);
        if (startVisible && endVisible) {
            return true;
        }
        int found = findCuts(line);
        if (startVisible || endVisible) {
            System.arraycopy(cuts, 0, line, startVisible ? 3 : 0, found > 0 ? 3 : 0);
            return found > 0;
        }
        System.arraycopy(cuts, 0, line, 0, found > 1 ? 6 : 0);
        return found > 1;
    }

    /** Computes the intersections of a line with the sides of the image. */
    private int findCuts(double[] line) {
        int found = 0;
        for (Vector3 side : sides) {
            double start = dot(side, line, 0);
            double end = dot(side, line, 3);
            if (start < 0 != end < 0) {
                double fraction = start / (start - end);
                for (int axis = 0; axis < 3; axis++) {
                    cuts[3 * found + axis] = line[axis] + fraction * (line[3 + axis] - line[axis]);
                }
                found += isInPicture(3 * found) ? 1 : 0;
            }
        }
        return found;
    }

    private boolean isInPicture(int at) {
        for (Vector3 side : sides) {
            if (dot(side, cuts, at) < -ROUNDING) {
                return false;
            }
        }
        return cuts[at + 1] >= MIN_DISTANCE;
    }

    private static double dot(Vector3 side, double[] point, int at) {
        return side.x() * point[at] + side.y() * point[at + 1] + side.z() * point[at + 2];
    }
}
