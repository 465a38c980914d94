package org.robonewbie.simulator.world;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.RigidBody;

/**
 * Limits that keep bodies within the range of the physics engine. Collision detection fails for NaN and for coordinates
 * beyond a few kilometres.
 */
final class WorldLimits {

    private static final double MAX_COORDINATE = 1000;
    static final double MAX_SPEED = 1000;

    private static final double MAX_FORCE = 1000;
    private static final double MAX_DISTANCE = 10 * MAX_COORDINATE;

    private WorldLimits() {}

    /** Limits each coordinate to 1 km; NaN becomes 0. */
    static Vector3 position(Vector3 metres) {
        return clamp(metres, MAX_COORDINATE);
    }

    /** Limits each component to 1000 m/s; NaN becomes 0. */
    static Vector3 velocity(Vector3 metresPerSecond) {
        return clamp(metresPerSecond, MAX_SPEED);
    }

    /** Limits each component to 1000 N; NaN becomes 0. */
    static Vector3 force(Vector3 newtons) {
        return clamp(newtons, MAX_FORCE);
    }

    static boolean isWithin(RigidBody body) {
        return body.isWithin(MAX_DISTANCE);
    }

    static boolean areWithin(List<RigidBody> bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            if (!isWithin(bodies.get(i))) {
                return false;
            }
        }
        return true;
    }

    private static Vector3 clamp(Vector3 vector, double limit) {
        return new Vector3(clamp(vector.x(), limit), clamp(vector.y(), limit), clamp(vector.z(), limit));
    }

    private static double clamp(double value, double limit) {
        return Double.isNaN(value) ? 0 : Math.max(-limit, Math.min(limit, value));
    }
}
