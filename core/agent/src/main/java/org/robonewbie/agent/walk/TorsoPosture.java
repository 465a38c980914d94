package org.robonewbie.agent.walk;

/**
 * How the torso is carried: what changes slowly, from one step to the next.
 *
 * @param amplitude 1 sways, bounces and lifts the feet as the gait says, 0 not at all
 * @param leanDegrees how much the torso bends forward
 * @param ankleOffset how far the ankles stand ahead of the hips, in metres
 */
public record TorsoPosture(double amplitude, double leanDegrees, double ankleOffset) {

    /**
     * Carries the torso as a gait does.
     *
     * @param gait the gait
     * @param amplitude 1 sways, bounces and lifts the feet as the gait says, 0 not at all
     * @return the torso's posture
     */
    public static TorsoPosture of(Gait gait, double amplitude) {
        return new TorsoPosture(amplitude, gait.leanDegrees(), gait.ankleOffset());
    }

    /**
     * Goes a part of the way to another posture.
     *
     * @param end the other posture
     * @param fraction 0 for this posture, 1 for the other
     * @return the posture on the way
     */
    TorsoPosture towards(TorsoPosture end, double fraction) {
        return new TorsoPosture(
                amplitude + fraction * (end.amplitude - amplitude),
                leanDegrees + fraction * (end.leanDegrees - leanDegrees),
                ankleOffset + fraction * (end.ankleOffset - ankleOffset));
    }
}
