package org.robonewbie.agent.walk;

/**
 * How strongly a walk answers when the torso leans otherwise than planned. Angles answer with degrees for each degree of lean
 * and for each degree per second, ways with metres.
 *
 * @param anklePitch ankle for each degree of bowing too far
 * @param anklePitchRate ankle for each degree per second of bowing
 * @param hipPitch hip for each degree of bowing too far
 * @param hipPitchRate hip for each degree per second of bowing
 * @param ankleRoll ankle for each degree of leaning too far to the right
 * @param ankleRollRate ankle for each degree per second of leaning to the right
 * @param hipRoll hip for each degree of leaning too far to the right
 * @param hipRollRate hip for each degree per second of leaning to the right
 * @param stepForward step for each degree of bowing too far
 * @param stepForwardRate step for each degree per second of bowing
 * @param stepRight step for each degree of leaning too far to the right
 * @param stepRightRate step for each degree per second of leaning to the right
 */
public record BalanceGains(
        double anklePitch,
        double anklePitchRate,
        double hipPitch,
        double hipPitchRate,
        double ankleRoll,
        double ankleRollRate,
        double hipRoll,
        double hipRollRate,
        double stepForward,
        double stepForwardRate,
        double stepRight,
        double stepRightRate) {

    /** Says what a walk changes. */
    void correct(Correction correction, double pitchError, double pitchRate, double rollError, double rollRate) {
        correction.setPitch(
                anklePitch * pitchError + anklePitchRate * pitchRate,
                hipPitch * pitchError + hipPitchRate * pitchRate,
                stepForward * pitchError + stepForwardRate * pitchRate);
        correction.setRoll(
                ankleRoll * rollError + ankleRollRate * rollRate,
                hipRoll * rollError + hipRollRate * rollRate,
                stepRight * rollError + stepRightRate * rollRate);
    }
}
