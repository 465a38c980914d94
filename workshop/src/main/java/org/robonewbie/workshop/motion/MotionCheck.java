package org.robonewbie.workshop.motion;

import java.util.function.LongFunction;

/**
 * Check of a motion by repeated trials.
 *
 * @param name name of the motion or the task
 * @param start description of the start of each trial
 * @param rule criterion of success
 * @param unit unit of the measured value
 * @param trial runs one trial with a seed
 * @param thoroughness factor on the number of trials
 */
public record MotionCheck(
        String name, String start, String rule, String unit, LongFunction<Outcome> trial, double thoroughness) {

    /**
     * Creates a check with the usual number of trials.
     *
     * @param name name of the motion or the task
     * @param start description of the start of each trial
     * @param rule criterion of success
     * @param unit unit of the measured value
     * @param trial runs one trial with a seed
     */
    public MotionCheck(String name, String start, String rule, String unit, LongFunction<Outcome> trial) {
        this(name, start, rule, unit, trial, 1);
    }

    /**
     * Multiplies the number of trials.
     *
     * @param factor factor on the number of trials
     * @return a copy of this check
     */
    MotionCheck thoroughly(double factor) {
        return new MotionCheck(name, start, rule, unit, trial, factor);
    }
}
