package org.robonewbie.nao.kinematics;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.robonewbie.nao.Vector3;

/** Convex hull of points on the ground, by Andrew's monotone chain (Information Processing Letters 9, 1979). */
final class ConvexHull {

    private static final double STRAIGHT = 1e-12;

    private ConvexHull() {}

    /** {@return the corners of the hull counter-clockwise, seen from above} */
    static List<Vector3> of(List<Vector3> points) {
        List<Vector3> sorted = new ArrayList<>(points);
        sorted.sort(Comparator.comparingDouble(Vector3::x).thenComparingDouble(Vector3::y));
        List<Vector3> hull = chain(sorted);
        Collections.reverse(sorted);
        hull.addAll(chain(sorted));
        return hull;
    }

    /** Returns the lower half of the hull without its last point, which is the first point of the other half. */
    private static List<Vector3> chain(List<Vector3> sorted) {
        List<Vector3> chain = new ArrayList<>();
        for (Vector3 point : sorted) {
            while (chain.size() > 1 && !turnsLeft(chain, point)) {
                chain.remove(chain.size() - 1);
            }
            chain.add(point);
        }
        return chain.isEmpty() ? chain : chain.subList(0, chain.size() - 1);
    }

    private static boolean turnsLeft(List<Vector3> chain, Vector3 point) {
        Vector3 corner = chain.get(chain.size() - 1);
        Vector3 before = chain.get(chain.size() - 2);
        return corner.minus(before).cross(point.minus(before)).z() > STRAIGHT;
    }
}
