package org.robonewbie.simulator.world;

import org.robonewbie.simulator.physics.PhysicsWorld;
import org.robonewbie.simulator.physics.ode.OdePhysicsWorld;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;

/** The world step of the product and the one that it is compared with: the same equations, results differ by rounding alone. */
public enum PhysicsEngine {
    /** The exact step of ode4j, the Java edition of the engine in rcssserver3d. */
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

    /** {@return a new, empty world} */
    public abstract PhysicsWorld newWorld();
}
