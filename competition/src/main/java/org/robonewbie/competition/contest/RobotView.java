package org.robonewbie.competition.contest;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.RobotSnapshot;

/**
 * A robot as a judge sees it, in the frame of its own team.
 *
 * @param snapshot the robot
 */
public record RobotView(RobotSnapshot snapshot) {

    /** Its number. */
    int number() {
        return snapshot.number();
    }

    /** The position of its torso: x to the opponents' goal, y to the left, metres. */
    Vector3 torso() {
        return JudgedMoment.turned(snapshot.body().position(), snapshot.side().orElse(TeamSide.LEFT));
    }

    /** Its heading in the world frame, counter-clockwise from the direction of the right goal. */
    double headingDegrees() {
        return snapshot.body().headingDegrees();
    }

    /** The tilt of its torso, 0 to 180 degrees. */
    double leanDegrees() {
        return snapshot.body().tiltDegrees();
    }

    /** Whether it has fallen. */
    boolean isFallen() {
        return snapshot.body().isFallen();
    }

    /** Whether it stands, its knees straight or bent. */
    boolean isUpright() {
        return snapshot.body().isStanding();
    }

    /** The angle of a joint in degrees. */
    double jointDegrees(Joint joint) {
        return snapshot.body().degrees(joint);
    }

    /** The height of a link's centre above the ground, metres. */
    double height(String link) {
        return snapshot.body().limbs().link(link).position().z();
    }
}
