package org.robonewbie.simulator.physics;

/** Shape that takes part in collision detection. */
public interface Collider {

    /** {@return the object that the collider belongs to, as passed on creation; identifies the objects in contact} */
    Object owner();
}
