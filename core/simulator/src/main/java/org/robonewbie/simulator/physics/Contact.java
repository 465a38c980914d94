package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/** Contact point of two colliders in one step. */
public interface Contact {

    /** {@return one of the two colliders} */
    Collider first();

    /** {@return the other collider} */
    Collider second();

    /** {@return the contact point in metres, as detected before the step} */
    Vector3 position();

    /**
     * Adds the contact force to running sums. The force acts on the body of the first collider and includes friction.
     * It is zero before the step, for a trigger, and between sleeping bodies.
     *
     * @param sums seven running sums, in newtons and newton metres: three for the force, three for the position times
     *     the magnitude of the force, and one for that magnitude
     */
    void addTo(double[] sums);
}
