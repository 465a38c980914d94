package org.robonewbie.simulator.physics;

/** Shape that takes part in collision detection. */
public interface Collider {

    /**
     * {@return the object that the collider belongs to, as passed when it was created; identifies the partners of a
     * contact}
     */
    Object owner();
}
