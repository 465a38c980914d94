package org.robonewbie.agent.walk;

/** Walks a robot other than the NAO, whose legs the {@link WalkEngine} cannot move. */
public interface Locomotion {

    /**
     * Sets the walking velocity.
     *
     * @param wanted the velocity; zero to stop
     */
    void towards(WalkVelocity wanted);

    /** {@return whether the robot is walking, including the steps until it has stopped} */
    boolean isWalking();
}
