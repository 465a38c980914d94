package org.robonewbie.agent.perception;

/** How the robot's torso is turned against the ground. */
public enum BodyPosition {
    /** The torso is upright or leans by less than 60 degrees. */
    UPRIGHT,
    /** The robot lies on its back and looks to the sky. */
    LYING_ON_BACK,
    /** The robot lies on its front. */
    LYING_ON_FRONT,
    /** The robot lies on its left side. */
    LYING_ON_LEFT_SIDE,
    /** The robot lies on its right side. */
    LYING_ON_RIGHT_SIDE;

    /** {@return whether the robot has to get up: this is anything but upright} */
    public boolean isFallen() {
        return this != UPRIGHT;
    }
}
