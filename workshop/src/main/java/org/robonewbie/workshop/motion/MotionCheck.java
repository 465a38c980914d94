package org.robonewbie.workshop.motion;

import java.util.function.LongFunction;

/**
 * Check of a motion by repeated trials.
 *
 * @param name name of the motion or the task
 * @param start description of how each trial starts
 * @param rule success criterion
 * @param unit unit of the measured value
 * @param trial runs one trial with a seed
 * @param thoroughness factor by which the number of trials is multiplied
 */
public record MotionCheck(
        String name, String start, String rule, String unit, LongFunction<Outcome> trial, double thoroughness) {

    /**
     * Creates a check with the default number of trials.
     *
     * @param name name of the motion or the task
     * @param start description of how each trial starts
     * @param rule success criterion
     * @param unit unit of the measured value
     * @param trial runs one trial with a seed
     */
    public MotionCheck(String name, String start, String rule, String unit, LongFunction<Outcome> trial) {
        this(name, start, rule, unit, trial, 1);
    }

    /**
     * Returns a copy with the given thoroughness.
     *
     * @param factor factor by which to multiply the number of trials
     * @return the copy
     */
    MotionCheck thoroughly(double factor) {
        return new MotionCheck(name, start, rule, unit, trial, factor);
    }
}
