package org.robonewbie.agent.walk;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.MutablePosture;

/**
 * One moment of a step: how far the swinging foot is, and how the torso sways and bounces. The object serves for all moments.
 */
final class StepMoment {

    private static final double EASING = 0.7;

    private final Gait gait;
    private Leg leg = Leg.LEFT;
    private double time;
    private double vigour;

    StepMoment(Gait gait) {
        this.gait = gait;
    }

    /**
     * Goes to a moment.
     *
     * @param swings which leg swings
     * @param newTime which part of the step is over, 0 to 1
     * @param newVigour 1 moves as the gait says, 0 not at all
     */
    void set(Leg swings, double newTime, double newVigour) {
        leg = swings;
        time = newTime;
        vigour = newVigour;
    }

    /** Which part of its way the swinging foot has made; it starts and stops softly. */
    double travelled() {
        double swing = swing();
        return swing - EASING * Math.sin(2 * Math.PI * swing) / (2 * Math.PI);
    }

    /** How high the swinging foot is, in metres. */
    double lift() {
        double skewed = Math.pow(swing(), Math.exp(-gait.liftSkew()));
        return gait.lift() * vigour * Math.pow(Math.sin(Math.PI * skewed), 1.2);
    }

    /** How far the torso is to the left, in metres. */
    double sway() {
        return sideways() * gait.sway();
    }

    /** How much the torso leans to the right, in degrees. */
    double rollDegrees() {
        return -sideways() * gait.roll();
    }

    /** How far the torso is above its usual height, in metres. */
    double bounce() {
        return gait.bounce() * vigour * Math.cos(2 * Math.PI * (time + gait.bouncePhase()));
    }

    /** How much the toes of the swinging foot are raised, in degrees. */
    double toeDegrees() {
        return gait.toeDegrees() * vigour * Math.sin(2 * Math.PI * swing());
    }

    /** Lifts the swinging leg to the side. */
    void liftHip(MutablePosture posture) {
        double outward = gait.swingHipDegrees() * vigour * Math.sin(Math.PI * swing());
        Joint hip = leg == Leg.LEFT ? Joint.LEFT_HIP_ROLL : Joint.RIGHT_HIP_ROLL;
        posture.add(hip, leg == Leg.LEFT ? outward : -outward);
    }

    /** From 1 on the left to -1 on the right. */
    private double sideways() {
        double side = leg == Leg.LEFT ? -1 : 1;
        return side * vigour * Math.sin(Math.PI * (time + gait.swayPhase()));
    }

    private double swing() {
        double swing = (time - gait.bothFeet() / 2) / (1 - gait.bothFeet());
        return Math.max(0, Math.min(1, swing));
    }
}
