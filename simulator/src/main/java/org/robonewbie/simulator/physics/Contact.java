package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/** One point where two colliders touch during one step. */
public interface Contact {

    /**
     * Names one side.
     *
     * @return the first collider
     */
    Collider first();

    /**
     * Names the other side.
     *
     * @return the second collider
     */
    Collider second();

    /**
     * Tells where they touch, as found before the step.
     *
     * @return a point in metres
     */
    Vector3 position();

    /**
     * Measures how the step pushed the first collider's body, friction included.
     *
     * @return newtons; zero before the step, for a trigger and between sleeping bodies
     */
    Vector3 forceOnFirst();
}
