package org.robonewbie.studio.search;

/**
 * Result of one round (generation) of an optimisation.
 *
 * @param number number of the round, starting at 1
 * @param best value of the best candidate
 * @param mean mean value of all candidates
 * @param success success rate of the trials, 0 to 1
 * @param step step size of the search distribution (sigma)
 * @param trialsPerSecond number of trials per second; 0 if the round was run before an interruption
 * @param secondsLeft estimated remaining time in seconds
 */
public record SearchRound(
        int number,
        double best,
        double mean,
        double success,
        double step,
        double trialsPerSecond,
        double secondsLeft) {}
