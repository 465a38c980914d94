package org.robonewbie.agent.walk;

import org.robonewbie.nao.kinematics.CoordinateFrame;

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

    /**
     * Places a foot flat on the ground.
     *
     * @param forward metres ahead of the torso's centre
     * @param left metres to the left of the torso's centre
     * @return the pose, toes straight ahead
     */
    public static FootPose flat(double forward, double left) {
        return new FootPose(forward, left, 0, 0, 0);
    }

    /** Lifts the foot to a height and raises its toes. */
    FootPose raised(double metres, double toesDegrees) {
        return new FootPose(forward, left, metres, yawDegrees, toesDegrees);
    }

    /** The frame of the foot's box, given that of the ground below the torso. */
    CoordinateFrame on(CoordinateFrame ground) {
        return ground.moved(forward, left, up)
                .turnedAboutZ(yawDegrees)
                .turnedAboutY(-toesUpDegrees)
                .moved(SOLE_TO_FOOT_CENTRE, 0, SOLE_THICKNESS);
    }
}
