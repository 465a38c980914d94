package org.robonewbie.agent.walk;

import org.robonewbie.nao.kinematics.CoordinateFrame;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Posture;

/**
 * Phase of a step, with the trajectories of the swing foot and the torso. With the step phase φ from 0 to 1 and the
 * double support ratio d, the swing phase is
 *
 * <pre>
 * σ = clamp((φ − d/2) / (1 − d), 0, 1)
 * </pre>
 *
 * <p>so both feet are on the ground during the first and the last d/2 of the step. The trajectories are sums of sines,
 * as in the open-loop gait of Behnke (2006): they need no model of the robot's mass, only amplitudes and phases that
 * were found by a search.
 *
 * @param gait amplitudes and phases
 * @param swing the swing leg
 * @param phase step phase, 0 to 1
 * @param torso posture of the torso, with the amplitude a
 */
record StepPhase(Gait gait, Leg swing, double phase, TorsoPosture torso) {

    private static final double HIPS_BELOW_TORSO = 0.115;

    /** Returns the completed fraction of the swing foot's path: σ − e sin(2πσ) / 2π with the easing e. */
    double travelled() {
        double part = swingPhase();
        return part - gait.swingEasing() * PortableMath.sin(2 * Math.PI * part) / (2 * Math.PI);
    }

    /**
     * Returns the height of the swing foot in metres: h · a · sin(πs)^1.2, where h is the lift height of the gait, a is
     * the amplitude, and s = σ^exp(−skew) shifts the peak according to the gait's lift skew.
     */
    double lift() {
        double skewed = PortableMath.pow(swingPhase(), PortableMath.exp(-gait.liftSkew()));
        return gait.liftHeight() * torso.amplitude() * PortableMath.pow(PortableMath.sin(Math.PI * skewed), 1.2);
    }

    /** Returns the lateral displacement of the torso over the support foot in metres, positive to the left. */
    double sway() {
        return sideways() * gait.swayAmplitude();
    }

    /** Returns the tilt of the torso to the right in degrees. */
    double rollDegrees() {
        return -sideways() * gait.rollDegrees();
    }

    /** Returns the vertical oscillation of the torso in metres, with one period in each step. */
    double bounce() {
        return gait.bounceAmplitude()
                * torso.amplitude()
                * PortableMath.cos(2 * Math.PI * (phase + gait.bouncePhase()));
    }

    /** Solves the inverse kinematics of both legs for feet below the tilted torso, starting from a posture. */
    Posture legs(InverseKinematics kinematics, Posture posture, FootPose left, FootPose right) {
        CoordinateFrame ground = ground();
        Posture withLeftLeg =
                kinematics.solve(Leg.LEFT, left.on(ground), posture).applyTo(posture);
        return kinematics.solve(Leg.RIGHT, right.on(ground), withLeftLeg).applyTo(withLeftLeg);
    }

    /** Returns the horizontal frame on the ground below the torso, which tilts about the midpoint between the hips. */
    private CoordinateFrame ground() {
        return CoordinateFrame.ORIGIN
                .moved(0, 0, -HIPS_BELOW_TORSO)
                .turnedAboutX(-rollDegrees())
                .turnedAboutY(-torso.leanDegrees())
                .moved(0, 0, HIPS_BELOW_TORSO - (gait.torsoHeight() + bounce()));
    }

    /** Returns the pitch of the swing foot's toes in degrees. */
    double toeDegrees() {
        return gait.toeDegrees() * torso.amplitude() * PortableMath.sin(2 * Math.PI * swingPhase());
    }

    /**
     * Returns the hip roll, in degrees, that lifts the swing leg sideways to compensate for the sinking of the pelvis.
     */
    double hipRollDegrees() {
        double outward = gait.swingHipDegrees() * torso.amplitude() * PortableMath.sin(Math.PI * swingPhase());
        return swing == Leg.LEFT ? outward : -outward;
    }

    /**
     * Returns the lateral oscillation a · sin(π(φ + p)) with the sway's phase lead p, from 1 on the left to −1 on the
     * right.
     */
    private double sideways() {
        double side = swing == Leg.LEFT ? -1 : 1;
        return side * torso.amplitude() * PortableMath.sin(Math.PI * (phase + gait.swayPhase()));
    }

    private double swingPhase() {
        double part = (phase - gait.doubleSupport() / 2) / (1 - gait.doubleSupport());
        return Math.max(0, Math.min(1, part));
    }
}
