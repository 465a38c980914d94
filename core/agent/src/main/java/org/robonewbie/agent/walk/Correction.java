package org.robonewbie.agent.walk;

import org.robonewbie.nao.Joint;

/**
 * Output of the balance control in one cycle of a step, see {@link BalanceGains}.
 *
 * @param anklePitchDegrees added to the pitch of both ankles; positive raises the toes
 * @param hipPitchDegrees added to the pitch of both hips; positive tilts the torso forward
 * @param ankleRollDegrees added to the roll of both ankles
 * @param hipRollDegrees added to the roll of both hips
 * @param swingForward shift of the swing foot's target forward, in metres
 * @param swingLeft shift of the swing foot's target to the left, in metres
 */
public record Correction(
        double anklePitchDegrees,
        double hipPitchDegrees,
        double ankleRollDegrees,
        double hipRollDegrees,
        double swingForward,
        double swingLeft) {

    private static final Joint[] JOINTS = Joint.values();
    private static final double MAX_DEGREES = 15;
    private static final double MAX_METRES = 0.05;

    /** Limits angles to 15° and shifts to 5 cm. */
    public Correction {
        anklePitchDegrees = limit(anklePitchDegrees, MAX_DEGREES);
        hipPitchDegrees = limit(hipPitchDegrees, MAX_DEGREES);
        ankleRollDegrees = limit(ankleRollDegrees, MAX_DEGREES);
        hipRollDegrees = limit(hipRollDegrees, MAX_DEGREES);
        swingForward = limit(swingForward, MAX_METRES);
        swingLeft = limit(swingLeft, MAX_METRES);
    }

    /** Adds the corrections to joint angles in the order of {@link Joint} and clamps the sums to the joints' ranges. */
    void addTo(double[] degrees) {
        degrees[Joint.LEFT_FOOT_PITCH.ordinal()] += anklePitchDegrees;
        degrees[Joint.RIGHT_FOOT_PITCH.ordinal()] += anklePitchDegrees;
        degrees[Joint.LEFT_HIP_PITCH.ordinal()] += hipPitchDegrees;
        degrees[Joint.RIGHT_HIP_PITCH.ordinal()] += hipPitchDegrees;
        degrees[Joint.LEFT_FOOT_ROLL.ordinal()] += ankleRollDegrees;
        degrees[Joint.RIGHT_FOOT_ROLL.ordinal()] += ankleRollDegrees;
        degrees[Joint.LEFT_HIP_ROLL.ordinal()] += hipRollDegrees;
        degrees[Joint.RIGHT_HIP_ROLL.ordinal()] += hipRollDegrees;
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = JOINTS[i].clampDegrees(degrees[i]);
        }
    }

    private static double limit(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }
}
