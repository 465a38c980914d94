package org.robonewbie.agent.walk;

/**
 * Where a foot is below the torso, in a frame that is level and looks to where the torso looks: the point of its sole below the
 * ankle.
 *
 * @param forward metres ahead of the torso's centre
 * @param left metres to the left of the torso's centre
 * @param up metres above the ground
 * @param yawDegrees where the toes point; positive is to the left
 * @param toesUpDegrees how much the toes are above the heel
 */
public record FootPose(double forward, double left, double up, double yawDegrees, double toesUpDegrees) {

    /**
     * Puts a foot flat on the ground.
     *
     * @param forward metres ahead of the torso's centre
     * @param left metres to the left of the torso's centre
     * @return the pose, toes straight ahead
     */
    public static FootPose flat(double forward, double left) {
        return new FootPose(forward, left, 0, 0, 0);
    }
}
