package org.robonewbie.agent.walk;

import org.robonewbie.nao.kinematics.MutablePose;

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

    private static final double SOLE_TO_FOOT_CENTRE = 0.03;
    private static final double SOLE_THICKNESS = 0.01;

    /** Goes from the ground below the torso to the centre of the foot's box. */
    void goOn(MutablePose pose) {
        goToFoot(pose, forward, left, up, yawDegrees, toesUpDegrees);
    }

    /** Goes from the ground below the torso to the centre of the box of a foot. */
    static void goToFoot(
            MutablePose pose, double forward, double left, double up, double yawDegrees, double toesUpDegrees) {
        pose.move(forward, left, up);
        pose.turnAboutZ(yawDegrees);
        pose.turnAboutY(-toesUpDegrees);
        pose.move(SOLE_TO_FOOT_CENTRE, 0, SOLE_THICKNESS);
    }

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
