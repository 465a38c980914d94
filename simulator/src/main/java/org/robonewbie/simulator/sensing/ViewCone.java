package org.robonewbie.simulator.sensing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * What lies within a camera's view, in the frame of the head: x right, y forward, z up.
 *
 * <p>Points are tested by their angles. A line of which an end is hidden is cut at the sides of the rectangular picture that
 * belongs to the cone, so that cut ends may lie slightly outside the angles.
 */
final class ViewCone {

    private static final double LEAST_DISTANCE = 0.1;
    private static final double ROUNDING = 1e-9;

    private final double halfHorizontal;
    private final double halfVertical;
    private final List<Vector3> sides;

    ViewCone(double horizontalDegrees, double verticalDegrees) {
        halfHorizontal = PortableMath.toRadians(horizontalDegrees) / 2;
        halfVertical = PortableMath.toRadians(verticalDegrees) / 2;
        double across = PortableMath.tan(halfHorizontal);
        double upward = PortableMath.tan(halfVertical);
        sides = List.of(
                new Vector3(1, across, 0),
                new Vector3(-1, across, 0),
                new Vector3(0, upward, -1),
                new Vector3(0, upward, 1));
    }

    /** Whether a point is seen; no cone reaches beyond what is ahead, and most points need no angles. */
    boolean contains(double x, double y, double z) {
        return y > 0
                && Math.sqrt(x * x + y * y + z * z) > LEAST_DISTANCE
                && Math.abs(PortableMath.atan2(x, y)) <= halfHorizontal
                && Math.abs(PortableMath.atan2(z, PortableMath.hypot(x, y))) <= halfVertical;
    }

    private boolean contains(Vector3 point) {
        return contains(point.x(), point.y(), point.z());
    }

    /** Cuts a line to what is seen of it: visible ends stay, hidden ones move to the edge of the picture. */
    Optional<Segment> clip(Segment line) {
        boolean startSeen = contains(line.start());
        boolean endSeen = contains(line.end());
        if (startSeen && endSeen) {
            return Optional.of(line);
        }
        List<Vector3> cuts = cuts(line);
        if (startSeen || endSeen) {
            return cuts.stream()
                    .findFirst()
                    .map(cut -> startSeen ? new Segment(line.start(), cut) : new Segment(cut, line.end()));
        }
        return cuts.size() < 2 ? Optional.empty() : Optional.of(new Segment(cuts.get(0), cuts.get(1)));
    }

    /** Points where a line crosses the sides of the picture: left, right, top, bottom. */
    private List<Vector3> cuts(Segment line) {
        List<Vector3> cuts = new ArrayList<>();
        for (Vector3 side : sides) {
            double start = side.dot(line.start());
            double end = side.dot(line.end());
            if (start < 0 != end < 0) {
                double share = start / (start - end);
                Vector3 cut = line.start().plus(line.end().minus(line.start()).times(share));
                if (isInPicture(cut)) {
                    cuts.add(cut);
                }
            }
        }
        return cuts;
    }

    private boolean isInPicture(Vector3 point) {
        for (Vector3 side : sides) {
            if (side.dot(point) < -ROUNDING) {
                return false;
            }
        }
        return point.y() >= LEAST_DISTANCE;
    }
}
