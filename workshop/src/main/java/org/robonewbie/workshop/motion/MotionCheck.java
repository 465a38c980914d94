package org.robonewbie.workshop.motion;

import java.util.function.LongFunction;

/**
 * A question about a motion that trials answer.
 *
 * @param name the motion, or what is done with it
 * @param start how each trial begins
 * @param rule when a trial is a success
 * @param unit what is measured
 * @param trial carries out one trial with a seed
 * @param thoroughness how many trials are made for each that is asked for
 */
public record MotionCheck(
        String name, String start, String rule, String unit, LongFunction<Outcome> trial, double thoroughness) {

    /**
     * Asks a question that needs no more trials than others.
     *
     * @param name the motion, or what is done with it
     * @param start how each trial begins
     * @param rule when a trial is a success
     * @param unit what is measured
     * @param trial carries out one trial with a seed
     */
    public MotionCheck(String name, String start, String rule, String unit, LongFunction<Outcome> trial) {
        this(name, start, rule, unit, trial, 1);
    }

    /**
     * Asks more thoroughly.
     *
     * @param factor how many trials are made for each that is asked for
     * @return the same question
     */
    MotionCheck thoroughly(double factor) {
        return new MotionCheck(name, start, rule, unit, trial, factor);
    }
}
