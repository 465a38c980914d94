package org.robonewbie.competition.contest;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.simulator.RobotSnapshot;

/**
 * What a judge sees of a robot, in the frame of its own team.
 *
 * @param snapshot the robot
 */
public record RobotView(RobotSnapshot snapshot) {

    private static final int NUMBERS_PER_POSE = 7;
    private static final double STANDING_DEGREES = 30;
    private static final double STANDING_METRES = 0.25;

    /** Tells its number. */
    int number() {
        return snapshot.number();
    }

    /** Tells where its torso is: x to the opponents' goal, y to the left, metres. */
    Vector3 torso() {
        int torso = NaoModel.of(snapshot.type()).linkIndex(NaoModel.TORSO);
        return Moment.turned(place(torso), snapshot.side().orElse(TeamSide.LEFT));
    }

    /** Tells where it looks to in the world frame, counter-clockwise from the direction of the right goal. */
    double headingDegrees() {
        double[] q = rotation();
        double forwardX = 2 * (q[1] * q[2] - q[0] * q[3]);
        double forwardY = 1 - 2 * (q[1] * q[1] + q[3] * q[3]);
        return Math.toDegrees(Math.atan2(forwardY, forwardX));
    }

    /** Tells how far its torso leans from the upright, 0 to 180 degrees. */
    double leanDegrees() {
        double[] q = rotation();
        double upward = 1 - 2 * (q[1] * q[1] + q[2] * q[2]);
        return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, upward))));
    }

    /** Tells whether it stands, its knees straight or bent. */
    boolean isUpright() {
        return leanDegrees() < STANDING_DEGREES && torso().z() > STANDING_METRES;
    }

    /** Tells the angle of a joint in degrees. */
    double jointDegrees(Joint joint) {
        return snapshot.jointDegrees()[NaoModel.of(snapshot.type()).hingeIndex(joint)];
    }

    /** Tells how high the centre of a link is above the ground, metres. */
    double height(String link) {
        return place(NaoModel.of(snapshot.type()).linkIndex(link)).z();
    }

    private Vector3 place(int link) {
        float[] poses = snapshot.linkPoses();
        int start = link * NUMBERS_PER_POSE;
        return new Vector3(poses[start], poses[start + 1], poses[start + 2]);
    }

    private double[] rotation() {
        int start = NaoModel.of(snapshot.type()).linkIndex(NaoModel.TORSO) * NUMBERS_PER_POSE + 3;
        float[] poses = snapshot.linkPoses();
        return new double[] {poses[start], poses[start + 1], poses[start + 2], poses[start + 3]};
    }
}
