package org.robonewbie.studio.search;

/**
 * What one round of a search has reached.
 *
 * @param number from 1
 * @param best value of its best candidate
 * @param mean mean value of its candidates
 * @param success share of its trials that succeed, 0 to 1
 * @param step size of the cloud from which the next candidates are drawn (sigma)
 * @param trialsPerSecond 0 if it was tried before an interruption
 * @param secondsLeft how long the rest will take
 */
public record SearchRound(
        int number,
        double best,
        double mean,
        double success,
        double step,
        double trialsPerSecond,
        double secondsLeft) {}
