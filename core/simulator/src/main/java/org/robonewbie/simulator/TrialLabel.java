package org.robonewbie.simulator;

/**
 * What is judged in a world, so that two trials of the same task can be laid over each other.
 *
 * @param task its name, such as {@code kick}
 * @param attempt counts how often the task was begun; the same number for all seeds of one attempt
 * @param seed what the trial began with: trials of one task and seed begin alike
 */
public record TrialLabel(String task, long attempt, long seed) {}
