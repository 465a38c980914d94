package org.robonewbie.learning.optimise;

/**
 * How an optimisation goes about it.
 *
 * @param seed chooses candidates and trials; the same seed gives the same result
 * @param generations how often candidates are drawn
 * @param population candidates in each generation, at least 4
 * @param trials trials of each candidate, at least 1
 * @param step spread of the first candidates in each coordinate
 * @param threads how many trials are carried out at the same time; the result does not depend on it
 */
public record OptimisationPlan(long seed, int generations, int population, int trials, double step, int threads) {

    /** Checks the numbers. */
    public OptimisationPlan {
        require(generations >= 1, "generations", generations, 1);
        require(population >= 4, "population", population, 4);
        require(trials >= 1, "seeds", trials, 1);
        if (!(step > 0 && step <= 10)) {
            throw new IllegalArgumentException("--step " + step + ": give a number greater than 0, at most 10.");
        }
        require(threads >= 1, "threads", threads, 1);
    }

    private static void require(boolean fine, String option, int value, int least) {
        if (!fine) {
            throw new IllegalArgumentException("--" + option + " " + value + ": give at least " + least + ".");
        }
    }
}
