package org.robonewbie.learning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/** Stopping criteria of a CMA-ES run (N. Hansen, Benchmarking a BI-Population CMA-ES on the BBOB-2009 Function Testbed, 2009). */
final class StoppingCriterion {

    private static final double MIN_DIFFERENCE = 1e-11;
    private static final double MIN_SPREAD = 1e-11;
    private static final double MAX_CONDITION = 1e14;
    private static final double SHARE_OF_HISTORY = 0.2;
    private static final double SHARE_COMPARED = 0.3;
    private static final int MAX_HISTORY = 20_000;

    private final int flatGenerations;
    private final int minHistory;
    private final List<Double> minima = new ArrayList<>();
    private final List<Double> medians = new ArrayList<>();
    private boolean flat;

    StoppingCriterion(int dimension, int population) {
        int perCandidate = (30 * dimension + population - 1) / population;
        this.flatGenerations = 10 + perCandidate;
        this.minHistory = 120 + perCandidate;
    }

    /** Adds the costs of a generation. */
    void add(double[] costs) {
        double[] sorted = costs.clone();
        Arrays.sort(sorted);
        minima.add(sorted[0]);
        medians.add(sorted[sorted.length / 2]);
        flat = sorted[sorted.length - 1] - sorted[0] < MIN_DIFFERENCE;
    }

    /**
     * Returns whether the run has converged or is stagnating.
     *
     * @param spread the largest standard deviation of a coordinate, relative to that of the first generation
     * @param condition the condition number of the covariance matrix
     */
    boolean isReached(double spread, double condition) {
        return spread < MIN_SPREAD
                || condition > MAX_CONDITION
                || isFlat()
                || (stagnates(minima) && stagnates(medians));
    }

    private boolean isFlat() {
        if (!flat || minima.size() < flatGenerations) {
            return false;
        }
        List<Double> last = minima.subList(minima.size() - flatGenerations, minima.size());
        return Collections.max(last) - Collections.min(last) < MIN_DIFFERENCE;
    }

    /**
     * Returns whether the median of the newest costs in the recent history is no smaller than that of the oldest costs.
     */
    private boolean stagnates(List<Double> history) {
        int length = Math.min(MAX_HISTORY, Math.max(minHistory, (int) (SHARE_OF_HISTORY * history.size())));
        if (history.size() < length) {
            return false;
        }
        List<Double> window = history.subList(history.size() - length, history.size());
        int part = (int) (SHARE_COMPARED * length);
        return median(window.subList(length - part, length)) >= median(window.subList(0, part));
    }

    private static double median(List<Double> numbers) {
        return numbers.stream().sorted().skip(numbers.size() / 2).findFirst().orElseThrow();
    }
}
