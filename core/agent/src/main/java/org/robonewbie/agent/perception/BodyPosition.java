package org.robonewbie.agent.perception;

/** Orientation of the robot's torso relative to the ground. */
public enum BodyPosition {
    /** The torso is upright or tilted by less than 60 degrees. */
    UPRIGHT,
    /** The robot is lying on its back. */
    LYING_ON_BACK,
    /** The robot is lying on its front. */
    LYING_ON_FRONT,
    /** The robot is lying on its left side. */
    LYING_ON_LEFT_SIDE,
    /** The robot is lying on its right side. */
    LYING_ON_RIGHT_SIDE;

    /** {@return whether the robot has to get up: true unless it is upright} */
    public boolean isFallen() {
        return this != UPRIGHT;
    }
}
