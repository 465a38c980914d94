package org.robonewbie.learning.search;

/** Tries out what a candidate is worth; called from several threads. */
@FunctionalInterface
public interface CostFunction {

    /**
     * Carries out one trial.
     *
     * @param candidate coordinates of the candidate; not to be changed
     * @param seed chooses the circumstances of the trial
     * @return the cost; smaller is better
     */
    double cost(double[] candidate, long seed);
}
