package org.robonewbie.agent.walk;

/**
 * What the sense of balance changes in a step.
 *
 * @param anklePitchDegrees added to both ankles; positive raises the toes
 * @param hipPitchDegrees added to both hips; positive bows the torso
 * @param ankleRollDegrees added to both ankles
 * @param hipRollDegrees added to both hips
 * @param swingForward how much further ahead the swinging foot is set down, metres
 * @param swingLeft how much further to the left the swinging foot is set down, metres
 */
public record Correction(
        double anklePitchDegrees,
        double hipPitchDegrees,
        double ankleRollDegrees,
        double hipRollDegrees,
        double swingForward,
        double swingLeft) {

    /** Everything goes as planned. */
    public static final Correction NONE = new Correction(0, 0, 0, 0, 0, 0);
}
