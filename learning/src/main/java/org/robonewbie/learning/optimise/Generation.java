package org.robonewbie.learning.optimise;

/**
 * What one generation of an optimisation has reached.
 *
 * @param number from 1
 * @param of how many there will be
 * @param best the value of its best candidate, in the unit of the objective
 * @param mean the mean value of all its candidates
 * @param success share of all its trials that ended as they should, 0 to 1
 * @param secondsLeft how long the rest will take, estimated from this run
 */
public record Generation(int number, int of, double best, double mean, double success, double secondsLeft) {}
