package org.robonewbie.agent.walk;

import java.util.Arrays;

/**
 * Parameters of {@link WalkStyle#FAST}: those of {@link WalkParameter} and eight more, including the maximum speeds.
 * They were found by CMA-ES on 23 November 2026, in 280 generations with seed 2 and 81 with seed 3.
 */
public final class FastWalk {

    /** Number of coordinates that {@link #style} takes. */
    public static final int PARAMETERS = WalkParameter.values().length + 8;

    /** Duration of a step in milliseconds. */
    private static final int STEP_MILLIS = 200;

    private static final double MAX_BACKWARD = 0.36;
    private static final double CHANGE_LEFT = 0.08;

    private static final double[] FOUND = {
        0.663, -2.203, 2.487, -2.198, 2.49, -0.14, -2.5, -0.291, 0.586, 0.46, -2.652, -0.525, -2.531, -2.431, 1.553,
        -0.587, -0.983, 0.306, -0.267, 2.368, 0.392, 2.875, -0.844, 1.487, -1.245, 5.668, 6.436, 3.636, 0.755, -0.416,
        -0.556, 3.887, -1.148, 1.176, 4.717, 1.906, -1.506, -1.097
    };

    private FastWalk() {}

    /** {@return the coordinates of the fast walk, as a new array} */
    public static double[] coordinates() {
        return FOUND.clone();
    }

    /**
     * Creates a style from coordinates in the search space.
     *
     * @param x {@link #PARAMETERS} coordinates
     * @return the style
     */
    public static WalkStyle style(double... x) {
        return style(STEP_MILLIS, x);
    }

    /**
     * Creates a style with the given step duration.
     *
     * @param stepMillis duration of a step in milliseconds, a multiple of 20
     * @param x {@link #PARAMETERS} coordinates
     * @return the style
     */
    public static WalkStyle style(int stepMillis, double... x) {
        double[] more = Arrays.copyOfRange(x, WalkParameter.values().length, PARAMETERS);
        WalkVelocity most = new WalkVelocity(0.75 + 0.1 * more[0], 0.22 + 0.03 * more[2], 90 + 20 * more[1]);
        WalkVelocity slip = new WalkVelocity(1.12 + 0.03 * more[3], 1.25, 1.2 + 0.05 * more[4]);
        WalkStyle style = WalkStyle.of(stepMillis, slip, most, x);
        double turnChange = Math.max(10, 25 + 3 * more[5]);
        double easing = Math.max(0, Math.min(1, 0.3 + 0.1 * more[6]));
        return new WalkStyle(
                Gait.of(stepMillis, x, 180 + 30 * more[7], easing),
                style.gains(),
                most,
                MAX_BACKWARD,
                new WalkVelocity(style.change().forward(), CHANGE_LEFT, turnChange),
                style.leanPerSpeed(),
                style.ankleOffsetPerSpeed(),
                style.leanPerChange(),
                slip);
    }
}
