package org.robonewbie.studio.search;

/**
 * Result of one round (generation) of an optimisation.
 *
 * @param number number of the round, from 1
 * @param best value of the best candidate
 * @param mean mean value of all candidates
 * @param success success rate of the trials, 0 to 1
 * @param step step size of the search distribution (sigma)
 * @param trialsPerSecond throughput; 0 if the round was run before an interruption
 * @param secondsLeft estimated remaining time
 */
public record SearchRound(
        int number,
        double best,
        double mean,
        double success,
        double step,
        double trialsPerSecond,
        double secondsLeft) {}
