package org.robonewbie.agent.walk;

import org.robonewbie.nao.kinematics.CoordinateFrame;

/**
 * Pose of a foot below the torso, in a horizontal frame with the heading of the torso. The reference point is the point of the
 * sole below the ankle.
 *
 * @param forward metres ahead of the torso's centre
 * @param left metres to the left of the torso's centre
 * @param up metres above the ground
 * @param yawDegrees direction of the toes; positive is left
 * @param toesUpDegrees pitch of the foot; positive raises the toes
 */
public record FootPose(double forward, double left, double up, double yawDegrees, double toesUpDegrees) {

    private static final double SOLE_TO_FOOT_CENTRE = 0.03;
    private static final double SOLE_THICKNESS = 0.01;

    FootPose raised(double metres, double toesDegrees) {
        return new FootPose(forward, left, metres, yawDegrees, toesDegrees);
    }

    /** Returns the frame of the foot's collision box, given the ground frame below the torso. */
    CoordinateFrame on(CoordinateFrame ground) {
        return ground.moved(forward, left, up)
                .turnedAboutZ(yawDegrees)
                .turnedAboutY(-toesUpDegrees)
                .moved(SOLE_TO_FOOT_CENTRE, 0, SOLE_THICKNESS);
    }
}
