package org.robonewbie.learning.objective;

/**
 * A question to which each trial gives a number as answer, such as "how far did it walk?".
 *
 * <pre>{@code
 * Gauge gauge = StandardObjective.WALK_SPEED.gauge();
 * while (trialGoesOn) {
 *     gauge.look(eye.look()); // after each cycle, see TrueStateEye
 * }
 * double metresPerSecond = gauge.value();
 * }</pre>
 */
public interface Objective {

    /**
     * Names the objective as on the command line.
     *
     * @return a name such as {@code walk-speed}
     */
    String label();

    /**
     * Tells in what it is measured.
     *
     * @return a unit such as {@code m/s}
     */
    String unit();

    /**
     * Tells which way is better.
     *
     * @return whether a larger value is better than a smaller one
     */
    boolean isLargerBetter();

    /**
     * Begins to measure one trial.
     *
     * @return a gauge that has not seen anything yet
     */
    Gauge gauge();
}
