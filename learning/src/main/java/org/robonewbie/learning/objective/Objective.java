package org.robonewbie.learning.objective;

/**
 * A measure of a trial, such as "how far did it walk?".
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

    /** {@return the objective's name on the command line, such as {@code walk-speed}} */
    String label();

    /** {@return the unit of the value, such as {@code m/s}} */
    String unit();

    /** {@return whether larger values are better} */
    boolean isLargerBetter();

    /**
     * Begins to measure one trial.
     *
     * @return a gauge that has not seen anything yet
     */
    Gauge gauge();
}
