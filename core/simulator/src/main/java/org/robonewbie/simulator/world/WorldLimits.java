package org.robonewbie.simulator.world;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.RigidBody;

/**
 * Keeps every body where the engine can still calculate, whatever a trainer or an accident asks for: beyond some kilometres,
 * or at a place that is no number, collision detection would fail.
 */
final class WorldLimits {

    private static final double LARGEST_COORDINATE = 1000;
    private static final double LARGEST_SPEED = 1000;
    private static final double LARGEST_FORCE = 1000;
    private static final double FARTHEST = 10 * LARGEST_COORDINATE;

    private WorldLimits() {}

    /** Limits a position to a kilometre; NaN becomes 0. */
    static Vector3 place(Vector3 wanted) {
        return cut(wanted, LARGEST_COORDINATE);
    }

    /** Limits a velocity to 1000 m/s; NaN becomes 0. */
    static Vector3 velocity(Vector3 wanted) {
        return cut(wanted, LARGEST_SPEED);
    }

    /** Limits a force to 1000 N; NaN becomes 0. */
    static Vector3 force(Vector3 wanted) {
        return cut(wanted, LARGEST_FORCE);
    }

    /** Whether a body may stay where it is. */
    static boolean isWithin(RigidBody body) {
        return body.isWithin(FARTHEST);
    }

    /** Whether all bodies of a robot may stay where they are; if not, it was torn apart. */
    static boolean areWithin(List<RigidBody> bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            if (!isWithin(bodies.get(i))) {
                return false;
            }
        }
        return true;
    }

    private static Vector3 cut(Vector3 vector, double limit) {
        return new Vector3(cut(vector.x(), limit), cut(vector.y(), limit), cut(vector.z(), limit));
    }

    private static double cut(double value, double limit) {
        return Double.isNaN(value) ? 0 : Math.max(-limit, Math.min(limit, value));
    }
}
