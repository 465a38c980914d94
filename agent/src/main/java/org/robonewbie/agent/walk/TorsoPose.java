package org.robonewbie.agent.walk;

import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.kinematics.MutablePose;
import org.robonewbie.nao.motion.MutablePosture;
import org.robonewbie.nao.motion.Posture;

/**
 * How the torso is held above the ground; with the feet below it this gives the angles of the legs. It leans about the middle
 * between the hips.
 *
 * @param height of the torso's centre above the ground while it is upright, metres
 * @param leanDegrees how much it bows forward
 * @param rollDegrees how much it leans to the right
 */
public record TorsoPose(double height, double leanDegrees, double rollDegrees) {

    private static final double HIPS_BELOW_TORSO = 0.115;

    /**
     * Finds the angles of both legs.
     *
     * @param kinematics the robot's
     * @param posture the other limbs; the search for the legs begins with it
     * @param left where the left foot is
     * @param right where the right foot is
     * @return the posture with both legs placed, or as near as they come
     */
    public Posture above(InverseKinematics kinematics, Posture posture, FootPose left, FootPose right) {
        MutablePosture placed = new MutablePosture(posture);
        MutablePose foot = new MutablePose();
        goToGround(foot, height, leanDegrees, rollDegrees);
        left.goOn(foot);
        kinematics.place(Leg.LEFT, foot, placed);
        goToGround(foot, height, leanDegrees, rollDegrees);
        right.goOn(foot);
        kinematics.place(Leg.RIGHT, foot, placed);
        return placed.toPosture();
    }

    /** Goes from the torso's centre to the point of the ground below it, level. */
    static void goToGround(MutablePose pose, double height, double leanDegrees, double rollDegrees) {
        pose.reset();
        pose.move(0, 0, -HIPS_BELOW_TORSO);
        pose.turnAboutX(-rollDegrees);
        pose.turnAboutY(-leanDegrees);
        pose.move(0, 0, HIPS_BELOW_TORSO - height);
    }
}
