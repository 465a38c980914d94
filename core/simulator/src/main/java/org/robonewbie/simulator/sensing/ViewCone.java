package org.robonewbie.simulator.sensing;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * What lies within a camera's view, in the frame of the head: x right, y forward, z up.
 *
 * <p>Points are tested by their angles. A line of which an end is hidden is cut at the sides of the rectangular picture that
 * belongs to the cone, so that cut ends may lie slightly outside the angles.
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

    /** Whether a point is seen; no cone reaches beyond what is ahead, and most points need no angles. */
    boolean contains(double x, double y, double z) {
        return y > 0
                && Math.sqrt(x * x + y * y + z * z) > MIN_DISTANCE
                && isWithin(x, y, halfHorizontal, across)
                && isWithin(z, PortableMath.hypot(x, y), halfVertical, upward);
    }

    /** Compares an angle with a limit, or where that is beyond doubt their tangents, which is quicker. */
    private static boolean isWithin(double aside, double ahead, double limit, double tangent) {
        double edge = tangent * ahead;
        if (limit < Math.PI / 2 && Math.abs(Math.abs(aside) - edge) > ROUNDING * edge) {
            return Math.abs(aside) < edge;
        }
        return Math.abs(PortableMath.atan2(aside, ahead)) <= limit;
    }

    /**
     * Cuts a line to what is seen of it: visible ends stay, hidden ones move to the edge of the picture.
     *
     * @param line the coordinates of both its ends, which are changed
     * @return whether any of it is seen
     */
    boolean clip(double[] line) {
        boolean startSeen = contains(line[0], line[1], line[2]);
        boolean endSeen = contains(line[3], line[4], line[5]);
        if (startSeen && endSeen) {
            return true;
        }
        int found = findCuts(line);
        if (startSeen || endSeen) {
            System.arraycopy(cuts, 0, line, startSeen ? 3 : 0, found > 0 ? 3 : 0);
            return found > 0;
        }
        System.arraycopy(cuts, 0, line, 0, found > 1 ? 6 : 0);
        return found > 1;
    }

    /** Finds the points where a line crosses the sides of the picture: left, right, top, bottom. */
    private int findCuts(double[] line) {
        int found = 0;
        for (Vector3 side : sides) {
            double start = dot(side, line, 0);
            double end = dot(side, line, 3);
            if (start < 0 != end < 0) {
                double share = start / (start - end);
                for (int axis = 0; axis < 3; axis++) {
                    cuts[3 * found + axis] = line[axis] + share * (line[3 + axis] - line[axis]);
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
