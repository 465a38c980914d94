package org.robonewbie.agent.walk;

/**
 * Parameters of a gait: everything about a step except where the feet go. The trajectories are those of {@link StepPhase}.
 * Lengths are in metres.
 *
 * @param stepMillis duration of a step, a multiple of 20 ms
 * @param torsoHeight height of the torso's centre above the soles
 * @param leanDegrees forward tilt of the torso
 * @param ankleOffset distance of the ankles ahead of the hips
 * @param footSpread lateral distance of each foot from its hip
 * @param swayAmplitude amplitude of the torso's sway over the support foot
 * @param swayPhase phase lead of the sway, as a fraction of a step
 * @param rollDegrees tilt of the torso over the support foot
 * @param liftHeight height to which the swing foot is lifted
 * @param liftSkew 0 for a symmetric lift; positive moves the peak to an earlier phase
 * @param doubleSupport fraction of a step in which both feet are on the ground
 * @param swingHipDegrees hip roll that lifts the swing leg sideways, to compensate for the sinking of the pelvis
 * @param toeDegrees amplitude of the toes' pitch, up at the beginning of the swing and down at its end
 * @param bounceAmplitude amplitude of the torso's vertical oscillation
 * @param bouncePhase phase lead of the bounce, as a fraction of a step
 * @param armSwing arm swing in degrees per metre of stride
 * @param swingEasing softness of the swing foot's start and stop: 0 moves at constant speed, 1 starts and ends at rest with a
 *     higher speed in between
 */
public record Gait(
        int stepMillis,
        double torsoHeight,
        double leanDegrees,
        double ankleOffset,
        double footSpread,
        double swayAmplitude,
        double swayPhase,
        double rollDegrees,
        double liftHeight,
        double liftSkew,
        double doubleSupport,
        double swingHipDegrees,
        double toeDegrees,
        double bounceAmplitude,
        double bouncePhase,
        double armSwing,
        double swingEasing) {

    /** Creates a gait from coordinates in the search space, see {@link WalkParameter}. */
    static Gait of(int stepMillis, double[] x, double armSwing, double swingEasing) {
        return new Gait(
                stepMillis,
                WalkParameter.TORSO_HEIGHT.value(x),
                WalkParameter.LEAN.value(x),
                WalkParameter.ANKLE_OFFSET.value(x),
                WalkParameter.FOOT_SPREAD.value(x),
                WalkParameter.SWAY_AMPLITUDE.value(x),
                WalkParameter.SWAY_PHASE.value(x),
                WalkParameter.ROLL.value(x),
                WalkParameter.LIFT_HEIGHT.value(x),
                WalkParameter.LIFT_SKEW.value(x),
                WalkParameter.DOUBLE_SUPPORT.value(x),
                WalkParameter.SWING_HIP.value(x),
                WalkParameter.TOES.value(x),
                WalkParameter.BOUNCE_AMPLITUDE.value(x),
                WalkParameter.BOUNCE_PHASE.value(x),
                armSwing,
                swingEasing);
    }
}
