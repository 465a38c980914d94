package org.robonewbie.agent.walk;

import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.math.PortableMath;

/**
 * One moment of a step: the curves that swing foot and torso follow. With the step phase φ from 0 to 1, the double support ratio
 * d and the amplitude a, the swing phase is
 *
 * <pre>
 * σ = clamp((φ − d/2) / (1 − d), 0, 1)
 * </pre>
 *
 * <p>so both feet are on the ground during the first and the last part d/2 of the step. The curves are sums of sines, as in the
 * open-loop gait of Behnke (2006): they need no model of the robot's mass, only amplitudes and phases that a search has found.
 *
 * @param gait its amplitudes and phases
 * @param swing which leg swings
 * @param phase which part of the step is over, 0 to 1
 * @param torso how the torso is carried, with the amplitude a
 */
record StepPhase(Gait gait, Leg swing, double phase, TorsoPosture torso) {

    /** Which part of its way the swing foot has made: σ − e sin(2πσ) / 2π with the easing e. */
    double travelled() {
        double part = swingPhase();
        return part - gait.swingEasing() * PortableMath.sin(2 * Math.PI * part) / (2 * Math.PI);
    }

    /** How high the swing foot is, in metres: h a sin(πs)^1.2, where s = σ^exp(−skew) moves the highest point. */
    double lift() {
        double skewed = PortableMath.pow(swingPhase(), PortableMath.exp(-gait.liftSkew()));
        return gait.liftHeight() * torso.amplitude() * PortableMath.pow(PortableMath.sin(Math.PI * skewed), 1.2);
    }

    /** How far the torso is to the left, in metres: it sways over the support foot. */
    double sway() {
        return sideways() * gait.swayAmplitude();
    }

    /** How much the torso leans to the right, in degrees. */
    double rollDegrees() {
        return -sideways() * gait.rollDegrees();
    }

    /** How far the torso is above its usual height, in metres: it rises and sinks once in each step. */
    double bounce() {
        return gait.bounceAmplitude()
                * torso.amplitude()
                * PortableMath.cos(2 * Math.PI * (phase + gait.bouncePhase()));
    }

    /** How the torso is held above the ground. */
    TorsoPose torsoPose() {
        return new TorsoPose(gait.torsoHeight() + bounce(), torso.leanDegrees(), rollDegrees());
    }

    /** How much the toes of the swing foot are raised, in degrees. */
    double toeDegrees() {
        return gait.toeDegrees() * torso.amplitude() * PortableMath.sin(2 * Math.PI * swingPhase());
    }

    /** How far the swing leg is lifted to the side, against the sinking of the pelvis, in degrees of hip roll. */
    double hipRollDegrees() {
        double outward = gait.swingHipDegrees() * torso.amplitude() * PortableMath.sin(Math.PI * swingPhase());
        return swing == Leg.LEFT ? outward : -outward;
    }

    /** The sideways oscillation a sin(π(φ + phase)), from 1 on the left to −1 on the right. */
    private double sideways() {
        double side = swing == Leg.LEFT ? -1 : 1;
        return side * torso.amplitude() * PortableMath.sin(Math.PI * (phase + gait.swayPhase()));
    }

    private double swingPhase() {
        double part = (phase - gait.doubleSupport() / 2) / (1 - gait.doubleSupport());
        return Math.max(0, Math.min(1, part));
    }
}
