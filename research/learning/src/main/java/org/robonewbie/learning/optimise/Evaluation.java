package org.robonewbie.learning.optimise;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;

/**
 * Result of a candidate in one trial, or its mean result over several trials.
 *
 * @param value the value of the objective, in its unit
 * @param success the fraction of trials that succeeded, 0 to 1
 * @param flaws penalty for other flaws, such as a swaying torso, relative to the scale of the value; 0 for none
 */
public record Evaluation(double value, double success, double flaws) implements Serializable {

    private static final double FAILURE_COST = 2;
    private static final double WORST_WEIGHT = 0.3;

    /**
     * Returns the cost for the search.
     *
     * @param sign 1 if smaller values are better, -1 if larger values are better
     * @param scale the scale of typical values, greater than 0
     * @return the cost; smaller is better
     */
    double cost(double sign, double scale) {
        return sign * value / scale + FAILURE_COST * (1 - success) + flaws;
    }

    static Evaluation mean(List<Evaluation> evaluations) {
        return new Evaluation(
                evaluations.stream().mapToDouble(Evaluation::value).average().orElse(0),
                evaluations.stream().mapToDouble(Evaluation::success).average().orElse(0),
                evaluations.stream().mapToDouble(Evaluation::flaws).average().orElse(0));
    }

    /** Returns the risk-averse cost of several trials: a weighted mean of their mean cost and their worst cost. */
    static double cost(List<Evaluation> evaluations, double sign, double scale) {
        double[] costs =
                evaluations.stream().mapToDouble(one -> one.cost(sign, scale)).toArray();
        double mean = Arrays.stream(costs).average().orElseThrow();
        double worst = Arrays.stream(costs).max().orElseThrow();
        return (1 - WORST_WEIGHT) * mean + WORST_WEIGHT * worst;
    }
}
