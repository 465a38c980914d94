package org.robonewbie.simulator.physics;

/** The surface of something that can touch or be touched. */
public interface Collider {

    /** {@return the object that the collider belongs to, as given when it was created; shows in a contact who touched whom} */
    Object owner();
}
