package org.robonewbie.learning.optimise;

import java.util.Locale;
import org.robonewbie.learning.search.AskAndTell;
import org.robonewbie.learning.search.CovarianceMatrixAdaptation;
import org.robonewbie.learning.search.RestartingSearch;

/**
 * Settings of an optimisation.
 *
 * @param seed the seed for candidates and trials; the same seed produces the same result
 * @param generations the number of generations, at least 1
 * @param population the number of candidates per generation, at least 4
 * @param trials the number of trials per candidate, at least 1
 * @param step the initial step size (sigma) in each coordinate, above 0 and at most 10
 * @param threads the number of parallel trials, at least 1; the result does not depend on it
 * @param plain whether to use CMA-ES without negative weights and without restarts
 */
public record OptimisationPlan(
        long seed, int generations, int population, int trials, double step, int threads, boolean plain) {

    /** Validates the settings. */
    public OptimisationPlan {
        require("generations", generations, 1);
        require("population", population, 4);
        require("seeds", trials, 1);
        if (!(step > 0 && step <= 10)) {
            throw new IllegalArgumentException("--step must be above 0 and at most 10, not " + step + ".");
        }
        require("threads", threads, 1);
    }

    /** Creates a search that starts at the origin of the coordinates. */
    AskAndTell search(int dimension) {
        double[] start = new double[dimension];
        return plain
                ? CovarianceMatrixAdaptation.plain(start, step, population, seed)
                : new RestartingSearch(start, step, population, seed);
    }

    /** Returns the options of {@code robonewbie optimise} for these settings. */
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

    private static void require(String option, int value, int min) {
        if (value < min) {
            throw new IllegalArgumentException("--" + option + " must be at least " + min + ", not " + value + ".");
        }
    }
}
