package org.robonewbie.agent.walk;

/**
 * How a robot steps: its whole way of walking except where the feet go. The curves are those of {@link StepPhase}. Lengths in
 * metres.
 *
 * @param stepMillis time of one step, a multiple of 20 ms times the keyframes
 * @param keyframesPerStep how many postures describe a step
 * @param torsoHeight of the torso's centre above the soles
 * @param leanDegrees forward lean of the torso
 * @param ankleOffset distance of the ankles ahead of the hips
 * @param footSpread how much wider than the hips each foot is set
 * @param swayAmplitude how far the torso sways over the support foot
 * @param swayPhase fraction of a step by which the sway leads
 * @param rollDegrees how much the torso leans over the support foot
 * @param liftHeight how high the swing foot is lifted
 * @param liftSkew 0 lifts evenly; positive is highest early in the step
 * @param doubleSupport fraction of a step during which both feet are on the ground
 * @param swingHipDegrees how much the hip lifts the swing leg to the side, against the sinking of the pelvis
 * @param toeDegrees how much the toes rise at the beginning of the swing and sink at its end
 * @param bounceAmplitude how far the torso rises and sinks in each step
 * @param bouncePhase fraction of a step by which the bounce leads
 * @param armSwing degrees of arm swing for each metre between the feet
 * @param swingEasing how softly the swing foot starts and stops: 0 moves it evenly, 1 from rest to rest. A soft foot has to be
 *     faster between
 */
public record Gait(
        int stepMillis,
        int keyframesPerStep,
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

    /** How many numbers {@link #of} takes. */
    public static final int PARAMETERS = WalkParameter.LIFT_SKEW.ordinal() + 1;

    private static final double ARM_SWING = 330;
    private static final double EASING = 0.7;

    /**
     * Creates a gait whose swing foot starts and stops softly.
     *
     * @param stepMillis time of one step, a multiple of 20 ms times the keyframes
     * @param keyframesPerStep how many postures describe a step
     * @param torsoHeight of the torso's centre above the soles
     * @param leanDegrees forward lean of the torso
     * @param ankleOffset distance of the ankles ahead of the hips
     * @param footSpread how much wider than the hips each foot is set
     * @param swayAmplitude how far the torso sways over the support foot
     * @param swayPhase fraction of a step by which the sway leads
     * @param rollDegrees how much the torso leans over the support foot
     * @param liftHeight how high the swing foot is lifted
     * @param liftSkew 0 lifts evenly; positive is highest early in the step
     * @param doubleSupport fraction of a step during which both feet are on the ground
     * @param swingHipDegrees how much the hip lifts the swing leg to the side, against the sinking of the pelvis
     * @param toeDegrees how much the toes rise at the beginning of the swing and sink at its end
     * @param bounceAmplitude how far the torso rises and sinks in each step
     * @param bouncePhase fraction of a step by which the bounce leads
     * @param armSwing degrees of arm swing for each metre between the feet
     */
    public Gait(
            int stepMillis,
            int keyframesPerStep,
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
            double armSwing) {
        this(
                stepMillis,
                keyframesPerStep,
                torsoHeight,
                leanDegrees,
                ankleOffset,
                footSpread,
                swayAmplitude,
                swayPhase,
                rollDegrees,
                liftHeight,
                liftSkew,
                doubleSupport,
                swingHipDegrees,
                toeDegrees,
                bounceAmplitude,
                bouncePhase,
                armSwing,
                EASING);
    }

    /**
     * Makes a gait from the coordinates of a search, see {@link WalkParameter}.
     *
     * @param stepMillis time of one step in milliseconds
     * @param keyframesPerStep how many postures describe a step
     * @param x at least {@link #PARAMETERS} coordinates
     * @return the gait
     */
    public static Gait of(int stepMillis, int keyframesPerStep, double[] x) {
        return new Gait(
                stepMillis,
                keyframesPerStep,
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
                ARM_SWING);
    }

    /**
     * Changes the arm swing.
     *
     * @param degreesPerMetre degrees of arm swing for each metre between the feet
     * @return the same gait with other arms
     */
    public Gait withArmSwing(double degreesPerMetre) {
        return with(degreesPerMetre, swingEasing);
    }

    /**
     * Changes how softly the swing foot starts and stops.
     *
     * @param easing 0 moves it evenly, 1 from rest to rest
     * @return the same gait with another swing
     */
    public Gait withSwingEasing(double easing) {
        return with(armSwing, easing);
    }

    private Gait with(double otherArmSwing, double otherEasing) {
        return new Gait(
                stepMillis,
                keyframesPerStep,
                torsoHeight,
                leanDegrees,
                ankleOffset,
                footSpread,
                swayAmplitude,
                swayPhase,
                rollDegrees,
                liftHeight,
                liftSkew,
                doubleSupport,
                swingHipDegrees,
                toeDegrees,
                bounceAmplitude,
                bouncePhase,
                otherArmSwing,
                otherEasing);
    }
}
