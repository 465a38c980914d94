package org.robonewbie.learning.search;

import java.util.Arrays;

/** Judges several trials of one candidate by their mean, drawn towards the worst of them. */
public final class RiskAverseMean {

    private static final double WEIGHT_OF_WORST = 0.3;

    private RiskAverseMean() {}

    /**
     * Takes trials together.
     *
     * @param costs what each trial has cost, at least one
     * @return between their mean and the greatest of them
     */
    public static double of(double[] costs) {
        double mean = Arrays.stream(costs).average().orElseThrow();
        double worst = Arrays.stream(costs).max().orElseThrow();
        return (1 - WEIGHT_OF_WORST) * mean + WEIGHT_OF_WORST * worst;
    }
}
