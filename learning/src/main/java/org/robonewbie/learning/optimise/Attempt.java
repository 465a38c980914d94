package org.robonewbie.learning.optimise;

import java.util.List;
import org.robonewbie.learning.search.CautiousMean;

/**
 * What a candidate has done in one trial, or in several.
 *
 * @param value what the objective measures, in its unit
 * @param success share of the trials that ended as they should, 0 to 1
 * @param flaws what is wrong with it besides, in parts of what the candidate is worth; 0 is nothing
 */
public record Attempt(double value, double success, double flaws) {

    private static final double COST_OF_FAILURE = 2;

    /**
     * Judges this attempt.
     *
     * @param sign 1 if smaller values are better, -1 if larger ones are
     * @param scale the size of usual values, greater than 0
     * @return the cost for the search; smaller is better
     */
    double cost(double sign, double scale) {
        return sign * value / scale + COST_OF_FAILURE * (1 - success) + flaws;
    }

    /** Takes several trials together. */
    static Attempt mean(List<Attempt> attempts) {
        return new Attempt(
                attempts.stream().mapToDouble(Attempt::value).average().orElse(0),
                attempts.stream().mapToDouble(Attempt::success).average().orElse(0),
                attempts.stream().mapToDouble(Attempt::flaws).average().orElse(0));
    }

    /** Judges several trials by their mean, drawn towards the worst of them. */
    static double cost(List<Attempt> attempts, double sign, double scale) {
        return CautiousMean.of(
                attempts.stream().mapToDouble(one -> one.cost(sign, scale)).toArray());
    }
}
