package org.robonewbie.agent.walk;

/**
 * Posture of the torso: the quantities that change from step to step.
 *
 * @param amplitude 1 for the sway, bounce and lift of the gait, 0 for none
 * @param leanDegrees forward tilt of the torso
 * @param ankleOffset distance of the ankles ahead of the hips, in metres
 */
public record TorsoPosture(double amplitude, double leanDegrees, double ankleOffset) {

    /**
     * Returns the posture of a gait.
     *
     * @param gait the gait
     * @param amplitude 1 for the sway, bounce and lift of the gait, 0 for none
     * @return the posture
     */
    public static TorsoPosture of(Gait gait, double amplitude) {
        return new TorsoPosture(amplitude, gait.leanDegrees(), gait.ankleOffset());
    }

    /**
     * Interpolates linearly to another posture.
     *
     * @param end the other posture
     * @param fraction 0 for this posture, 1 for the other
     * @return the posture in between
     */
    TorsoPosture towards(TorsoPosture end, double fraction) {
        return new TorsoPosture(
                amplitude + fraction * (end.amplitude - amplitude),
                leanDegrees + fraction * (end.leanDegrees - leanDegrees),
                ankleOffset + fraction * (end.ankleOffset - ankleOffset));
    }
}
