package org.robonewbie.agent.walk;

/**
 * All numbers of a walk. Most were found by a search in the simulator; {@code EngineDesign} of the module learning is its tool.
 *
 * @param gait how the robot steps
 * @param gains how it keeps its balance
 * @param most the largest speeds
 * @param backward the largest speed backward, metres per second
 * @param change how much each speed changes from one step to the next
 * @param leanPerSpeed degrees that the torso bows for each metre per second
 * @param feetPerSpeed metres that the feet stand further ahead for each metre per second
 * @param leanPerChange degrees that the torso bows for each metre per second that the walk becomes faster in a step
 * @param slip by which factors the feet are set further than the robot shall get, since it slips
 */
public record WalkStyle(
        Gait gait,
        BalanceGains gains,
        WalkVelocity most,
        double backward,
        WalkVelocity change,
        double leanPerSpeed,
        double feetPerSpeed,
        double leanPerChange,
        WalkVelocity slip) {

    private static final double DEGREES_OF_ARM_FOR_EACH_METRE = 180;

    private static final double[] COORDINATES = {
        2.1, -1.5, 1.1, -1.3, 3.3, 0.3, -3.3, 0.1, 0.0, -0.3, -2.6, -0.5, 3.0, -1.4, 2.1, -0.2, -0.5, 0.7, 0.4, 0.1,
        -1.0, 1.2, 0.8, -0.8, 0.5, 3.0, 0.9, 0.1, -1.7, -0.0
    };

    /** The walk of {@link Walk}. */
    public static final WalkStyle STANDARD = standard(COORDINATES);

    /** How many numbers {@link #of} takes. */
    public static final int PARAMETERS = Gait.PARAMETERS + 16;

    /**
     * Gives the coordinates that {@link #of} takes for the standard walk.
     *
     * @return a copy
     */
    public static double[] coordinates() {
        return COORDINATES.clone();
    }

    /**
     * Makes the standard walk with other coordinates.
     *
     * @param x coordinates as for {@link #of}
     * @return a walk with the same step time and the same largest speeds
     */
    public static WalkStyle standard(double[] x) {
        return of(200, new WalkVelocity(1.12, 1.25, 1.2), new WalkVelocity(0.6, 0.22, 70), x);
    }

    /**
     * Makes a style from the coordinates of a search, in which 0 is a careful first guess and 1 a noticeable change.
     *
     * @param stepMillis time of one step in milliseconds
     * @param slip by which factors the feet are set further than the robot shall get
     * @param most the largest speeds
     * @param x at least {@link #PARAMETERS} coordinates
     * @return the style
     */
    public static WalkStyle of(int stepMillis, WalkVelocity slip, WalkVelocity most, double[] x) {
        int i = Gait.PARAMETERS;
        BalanceGains gains = new BalanceGains(
                0.1 * x[i],
                0.01 * x[i + 1],
                0.1 * x[i + 2],
                0.01 * x[i + 3],
                0.1 * x[i + 4],
                0.01 * x[i + 5],
                0.1 * x[i + 6],
                0.01 * x[i + 7],
                0.001 * x[i + 8],
                0.0001 * x[i + 9],
                0.001 * x[i + 10],
                0.0001 * x[i + 11]);
        double change = Math.max(0.02, 0.08 + 0.02 * x[i + 12]);
        return new WalkStyle(
                Gait.of(stepMillis, 1, x).withArmSwing(DEGREES_OF_ARM_FOR_EACH_METRE),
                gains,
                most,
                0.6 * most.forward(),
                new WalkVelocity(change, 0.08, 25),
                3 * x[i + 13],
                0.01 * x[i + 14],
                10 * x[i + 15],
                slip);
    }
}
