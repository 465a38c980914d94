package org.robonewbie.agent.walk;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
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
    private static final Vector3 SOLE_TO_FOOT_CENTRE = new Vector3(0.03, 0, 0.01);

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
        Posture oneLeg = kinematics.solve(Leg.LEFT, seen(left), posture).applyTo(posture);
        return kinematics.solve(Leg.RIGHT, seen(right), oneLeg).applyTo(oneLeg);
    }

    /** The centre of a foot's box as seen from the torso. */
    private Pose seen(FootPose foot) {
        Rotation level = Rotation.ofYawPitchRoll(0, leanDegrees, rollDegrees).inverse();
        Rotation turn = level.times(Rotation.ofYawPitchRoll(foot.yawDegrees(), -foot.toesUpDegrees(), 0));
        Vector3 fromHips = new Vector3(foot.forward(), foot.left(), foot.up() + HIPS_BELOW_TORSO - height);
        Vector3 sole = level.apply(fromHips).minus(new Vector3(0, 0, HIPS_BELOW_TORSO));
        return new Pose(sole.plus(turn.apply(SOLE_TO_FOOT_CENTRE)), turn);
    }
}
