package org.robonewbie.simulator.physics;

/** The surface of something that can touch or be touched. */
public interface Collider {

    /**
     * Tells what the surface belongs to, so that whoever reads contacts knows who touched whom.
     *
     * @return the owner that was given when the collider was made
     */
    Object owner();
}
