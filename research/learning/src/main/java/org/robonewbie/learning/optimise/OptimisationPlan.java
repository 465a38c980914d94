package org.robonewbie.learning.optimise;

import java.util.Locale;
import org.robonewbie.learning.search.AskAndTell;
import org.robonewbie.learning.search.CovarianceMatrixAdaptation;
import org.robonewbie.learning.search.RestartingSearch;

/**
 * How an optimisation goes about it.
 *
 * @param seed chooses candidates and trials; the same seed gives the same result
 * @param generations how often candidates are drawn
 * @param population candidates in each generation, at least 4
 * @param trials trials of each candidate, at least 1
 * @param step spread of the first candidates in each coordinate
 * @param threads how many trials are carried out at the same time; the result does not depend on it
 * @param plain whether to search by plain CMA-ES, without learning from bad candidates and without beginning again
 */
public record OptimisationPlan(
        long seed, int generations, int population, int trials, double step, int threads, boolean plain) {

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

    /** Returns a new search around the origin of a space. */
    AskAndTell search(int dimension) {
        double[] start = new double[dimension];
        return plain
                ? CovarianceMatrixAdaptation.plain(start, step, population, seed)
                : new RestartingSearch(start, step, population, seed);
    }

    /** Returns the options of {@code robonewbie optimise} that lead to the same search. */
    String options(boolean withGenerations) {
        return String.format(
                Locale.ROOT,
                "%s--population %d --seed %d --seeds %d --step %s%s",
                withGenerations ? "--generations " + generations + " " : "",
                population,
                seed,
                trials,
                step,
                plain ? " --plain" : "");
    }

    private static void require(boolean fine, String option, int value, int least) {
        if (!fine) {
            throw new IllegalArgumentException("--" + option + " " + value + ": give at least " + least + ".");
        }
    }
}
