package org.robonewbie.simulator;

/**
 * The identity of a graded trial. Two trials with the same task and seed start identically and can be overlaid.
 *
 * @param task name of the task, such as {@code kick}
 * @param attempt number of the attempt at the task, shared by all seeds of the attempt
 * @param seed the seed of the trial
 */
public record TrialLabel(String task, long attempt, long seed) {}
