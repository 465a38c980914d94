package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/** One point where two colliders touch during one step. */
public interface Contact {

    /** {@return one of the two colliders} */
    Collider first();

    /** {@return the other collider} */
    Collider second();

    /** {@return the point of contact in metres, as found before the step} */
    Vector3 position();

    /**
     * Measures how the step pushed the first collider's body, friction included.
     *
     * @return newtons; zero before the step, for a trigger and between sleeping bodies
     */
    Vector3 forceOnFirst();
}
