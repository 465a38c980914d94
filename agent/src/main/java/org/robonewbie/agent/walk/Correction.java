package org.robonewbie.agent.walk;

/** What the sense of balance changes in a step; nothing at first. {@link BalanceGains} says how much, anew in each cycle. */
public final class Correction {

    private static final double MOST_DEGREES = 15;
    private static final double MOST_METRES = 0.05;

    private double anklePitchDegrees;
    private double hipPitchDegrees;
    private double ankleRollDegrees;
    private double hipRollDegrees;
    private double swingForward;
    private double swingLeft;

    /** Creates a correction that changes nothing. */
    public Correction() {}

    /** Answers to bowing too far or too fast. */
    void setPitch(double ankleDegrees, double hipDegrees, double stepForward) {
        anklePitchDegrees = limit(ankleDegrees, MOST_DEGREES);
        hipPitchDegrees = limit(hipDegrees, MOST_DEGREES);
        swingForward = limit(stepForward, MOST_METRES);
    }

    /** Answers to leaning too far or too fast to the right. */
    void setRoll(double ankleDegrees, double hipDegrees, double stepRight) {
        ankleRollDegrees = limit(ankleDegrees, MOST_DEGREES);
        hipRollDegrees = limit(hipDegrees, MOST_DEGREES);
        swingLeft = -limit(stepRight, MOST_METRES);
    }

    /** Added to both ankles; positive raises the toes. */
    double anklePitchDegrees() {
        return anklePitchDegrees;
    }

    /** Added to both hips; positive bows the torso. */
    double hipPitchDegrees() {
        return hipPitchDegrees;
    }

    /** Added to both ankles. */
    double ankleRollDegrees() {
        return ankleRollDegrees;
    }

    /** Added to both hips. */
    double hipRollDegrees() {
        return hipRollDegrees;
    }

    /** How much further ahead the swinging foot is set down, metres. */
    double swingForward() {
        return swingForward;
    }

    /** How much further to the left the swinging foot is set down, metres. */
    double swingLeft() {
        return swingLeft;
    }

    private static double limit(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }
}
