package org.robonewbie.learning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Decides when a search has come to its end, so that more of it would only cost trials (N. Hansen, Benchmarking a BI-Population
 * CMA-ES, 2009).
 */
final class StoppingCriterion {

    private static final double LEAST_DIFFERENCE = 1e-11;
    private static final double LEAST_SPREAD = 1e-11;
    private static final double LARGEST_CONDITION = 1e14;
    private static final double SHARE_OF_HISTORY = 0.2;
    private static final double SHARE_COMPARED = 0.3;
    private static final int LONGEST_HISTORY = 20_000;

    private final int flatGenerations;
    private final int leastHistory;
    private final List<Double> least = new ArrayList<>();
    private final List<Double> median = new ArrayList<>();
    private boolean flat;

    StoppingCriterion(int dimension, int population) {
        int perCandidate = (30 * dimension + population - 1) / population;
        this.flatGenerations = 10 + perCandidate;
        this.leastHistory = 120 + perCandidate;
    }

    /** Takes note of the costs of a generation. */
    void note(double[] costs) {
        double[] sorted = costs.clone();
        Arrays.sort(sorted);
        least.add(sorted[0]);
        median.add(sorted[sorted.length / 2]);
        flat = sorted[sorted.length - 1] - sorted[0] < LEAST_DIFFERENCE;
    }

    /**
     * Whether the search has ended.
     *
     * @param spread the largest standard deviation of a coordinate, in that of the first candidates
     * @param condition how much longer the cloud is than wide, squared
     */
    boolean isReached(double spread, double condition) {
        return spread < LEAST_SPREAD
                || condition > LARGEST_CONDITION
                || isFlat()
                || (stagnates(least) && stagnates(median));
    }

    private boolean isFlat() {
        if (!flat || least.size() < flatGenerations) {
            return false;
        }
        List<Double> last = least.subList(least.size() - flatGenerations, least.size());
        return last.stream().mapToDouble(Double::doubleValue).max().orElseThrow()
                        - last.stream().mapToDouble(Double::doubleValue).min().orElseThrow()
                < LEAST_DIFFERENCE;
    }

    /** Whether the newest costs of the history are no smaller than its oldest ones. */
    private boolean stagnates(List<Double> history) {
        int length = Math.min(LONGEST_HISTORY, Math.max(leastHistory, (int) (SHARE_OF_HISTORY * history.size())));
        if (history.size() < length) {
            return false;
        }
        List<Double> window = history.subList(history.size() - length, history.size());
        int part = (int) (SHARE_COMPARED * length);
        return middle(window.subList(length - part, length)) >= middle(window.subList(0, part));
    }

    private static double middle(List<Double> numbers) {
        return numbers.stream().sorted().skip(numbers.size() / 2).findFirst().orElseThrow();
    }
}
