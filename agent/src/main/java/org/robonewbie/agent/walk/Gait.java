package org.robonewbie.agent.walk;

/**
 * How a robot steps: all about its way of walking but where the feet go. Lengths in metres.
 *
 * @param stepMillis time of one step, a multiple of 20 ms times the keyframes
 * @param keyframesPerStep how many postures describe a step
 * @param torsoHeight of the torso's centre above the soles
 * @param leanDegrees how much the torso bows forward
 * @param feetForward how far the ankles stand ahead of the hips
 * @param feetApart how much wider than the hips each foot is set
 * @param sway how far the torso swings to the side of the standing leg
 * @param swayPhase by which part of a step the swinging is early
 * @param roll how many degrees the torso leans to the side of the standing leg
 * @param lift how high the foot is lifted
 * @param liftSkew 0 lifts evenly; positive is highest late in the step
 * @param bothFeet which part of a step both feet stay on the ground
 * @param swingHipDegrees how much the hip lifts the swinging leg to the side, against the sinking of the pelvis
 * @param toeDegrees how much the toes rise at the beginning of the swing and sink at its end
 * @param bounce how far the torso rises and sinks twice in each step
 * @param bouncePhase by which part of a step the rising is early
 * @param armSwing degrees of arm swing for each metre between the feet
 */
public record Gait(
        int stepMillis,
        int keyframesPerStep,
        double torsoHeight,
        double leanDegrees,
        double feetForward,
        double feetApart,
        double sway,
        double swayPhase,
        double roll,
        double lift,
        double liftSkew,
        double bothFeet,
        double swingHipDegrees,
        double toeDegrees,
        double bounce,
        double bouncePhase,
        double armSwing) {

    /** How many numbers {@link #of} takes. */
    public static final int PARAMETERS = 14;

    private static final double HIGHEST_TORSO = 0.375;

    /**
     * Makes a gait from the coordinates of a search, in which 0 is a careful first guess and 1 a noticeable change.
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
                Math.min(HIGHEST_TORSO, 0.335 + 0.01 * x[0]),
                5 + 3 * x[1],
                -0.01 * x[2],
                0.005 * x[12],
                0.02 + 0.008 * x[3],
                0.1 / Math.PI * x[4],
                2 * x[7],
                Math.max(0.005, 0.025 + 0.01 * x[5]),
                0.1 * x[13],
                Math.max(0, Math.min(0.6, 0.2 + 0.1 * x[6])),
                2 * x[8],
                4 * x[9],
                0.003 * x[10],
                0.15 * x[11],
                330);
    }

    /**
     * Swings the arms otherwise.
     *
     * @param degreesPerMetre degrees of arm swing for each metre between the feet
     * @return the same gait with other arms
     */
    public Gait withArmSwing(double degreesPerMetre) {
        return new Gait(
                stepMillis,
                keyframesPerStep,
                torsoHeight,
                leanDegrees,
                feetForward,
                feetApart,
                sway,
                swayPhase,
                roll,
                lift,
                liftSkew,
                bothFeet,
                swingHipDegrees,
                toeDegrees,
                bounce,
                bouncePhase,
                degreesPerMetre);
    }
}
