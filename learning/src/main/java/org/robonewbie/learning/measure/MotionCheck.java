package org.robonewbie.learning.measure;

import java.util.function.LongFunction;

/**
 * A question about a motion that trials answer.
 *
 * @param name the motion, or what is done with it
 * @param start how each trial begins
 * @param rule when a trial is a success
 * @param unit what is measured
 * @param trial carries out one trial with a seed
 */
public record MotionCheck(String name, String start, String rule, String unit, LongFunction<Outcome> trial) {}
