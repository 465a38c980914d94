package org.robonewbie.learning.optimise;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;

/**
 * What a candidate has done in one trial, or in several.
 *
 * @param value what the objective measures, in its unit
 * @param success share of the trials that ended as they should, 0 to 1
 * @param flaws what is wrong with it besides, in parts of what the candidate is worth; 0 is nothing
 */
public record Evaluation(double value, double success, double flaws) implements Serializable {

    private static final double COST_OF_FAILURE = 2;
    private static final double WEIGHT_OF_WORST = 0.3;

    /**
     * Judges this evaluation.
     *
     * @param sign 1 if smaller values are better, -1 if larger ones are
     * @param scale the size of usual values, greater than 0
     * @return the cost for the search; smaller is better
     */
    double cost(double sign, double scale) {
        return sign * value / scale + COST_OF_FAILURE * (1 - success) + flaws;
    }

    /** Takes several trials together. */
    static Evaluation mean(List<Evaluation> evaluations) {
        return new Evaluation(
                evaluations.stream().mapToDouble(Evaluation::value).average().orElse(0),
                evaluations.stream().mapToDouble(Evaluation::success).average().orElse(0),
                evaluations.stream().mapToDouble(Evaluation::flaws).average().orElse(0));
    }

    /** Judges several trials by their mean, drawn towards the worst of them. */
    static double cost(List<Evaluation> evaluations, double sign, double scale) {
        double[] costs =
                evaluations.stream().mapToDouble(one -> one.cost(sign, scale)).toArray();
        double mean = Arrays.stream(costs).average().orElseThrow();
        double worst = Arrays.stream(costs).max().orElseThrow();
        return (1 - WEIGHT_OF_WORST) * mean + WEIGHT_OF_WORST * worst;
    }
}
