package org.robonewbie.agent.walk;

import org.robonewbie.nao.kinematics.CoordinateFrame;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Posture;

/**
 * How the torso is held above the ground; with the feet below it this gives the angles of the legs. It leans about the middle
 * between the hips.
 *
 * @param height of the torso's centre above the ground while it is upright, metres
 * @param leanDegrees how much it bends forward
 * @param rollDegrees how much it leans to the right
 */
public record TorsoPose(double height, double leanDegrees, double rollDegrees) {

    private static final double HIPS_BELOW_TORSO = 0.115;

    /**
     * Calculates the angles of both legs.
     *
     * @param kinematics the robot's
     * @param posture the other limbs; the search for the legs begins with it
     * @param left where the left foot is
     * @param right where the right foot is
     * @return the posture with both legs placed, or as near as they come
     */
    public Posture above(InverseKinematics kinematics, Posture posture, FootPose left, FootPose right) {
        CoordinateFrame ground = ground();
        Posture withLeftLeg =
                kinematics.solve(Leg.LEFT, left.on(ground), posture).applyTo(posture);
        return kinematics.solve(Leg.RIGHT, right.on(ground), withLeftLeg).applyTo(withLeftLeg);
    }

    /** The point of the ground below the torso, level, as seen from the torso's centre. */
    private CoordinateFrame ground() {
        return CoordinateFrame.ORIGIN
                .moved(0, 0, -HIPS_BELOW_TORSO)
                .turnedAboutX(-rollDegrees)
                .turnedAboutY(-leanDegrees)
                .moved(0, 0, HIPS_BELOW_TORSO - height);
    }
}
