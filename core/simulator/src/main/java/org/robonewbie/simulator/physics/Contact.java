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

    /**
     * Adds up contacts.
     *
     * @param sums to these are added the force, its place times its strength, and its strength, seven numbers
     */
    default void addTo(double[] sums) {
        Vector3 force = forceOnFirst();
        Vector3 place = position();
        double strength = force.length();
        sums[0] += force.x();
        sums[1] += force.y();
        sums[2] += force.z();
        sums[3] += strength * place.x();
        sums[4] += strength * place.y();
        sums[5] += strength * place.z();
        sums[6] += strength;
    }
}
