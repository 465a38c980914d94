package org.robonewbie.simulator.world;

import java.util.Locale;
import org.robonewbie.simulator.physics.PhysicsWorld;
import org.robonewbie.simulator.physics.ode.OdePhysicsWorld;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;

/** What computes the motion of all bodies. Both solve the same equations; their results differ by rounding alone. */
public enum PhysicsEngine {
    /** The exact step of ode4j, the Java edition of the engine in rcssserver3d; slow when robots pile up. */
    EXACT {
        @Override
        public PhysicsWorld newWorld() {
            return new OdePhysicsWorld();
        }
    },
    /** Our own step, which exploits that a robot is a tree of bodies. */
    FAST {
        @Override
        public PhysicsWorld newWorld() {
            return new SparsePhysicsWorld();
        }
    };

    /** The engine that is used where none is named. */
    public static final PhysicsEngine STANDARD = FAST;

    /** {@return a new, empty world} */
    public abstract PhysicsWorld newWorld();

    /** {@return the engine's name on the command line, "exact" or "fast"} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
