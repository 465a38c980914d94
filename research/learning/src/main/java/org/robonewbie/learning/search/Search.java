package org.robonewbie.learning.search;

import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/**
 * Looks for coordinates that cost little in many trials. Trials run in parallel on the processors of the machine; the result
 * depends on the plan only.
 *
 * <pre>{@code
 * double[] found = new Search(plan, trial).run(start, progress -> System.out.println(progress));
 * }</pre>
 */
public final class Search {

    private final SearchPlan plan;
    private final CostFunction trial;

    /**
     * Prepares a search.
     *
     * @param plan how long and how widely it looks
     * @param trial what candidates are tried with
     */
    public Search(SearchPlan plan, CostFunction trial) {
        this.plan = plan;
        this.trial = trial;
    }

    /**
     * Runs the search.
     *
     * @param start where the search starts
     * @param listener called for each generation
     * @return the centre of the last candidates
     */
    public double[] run(double[] start, Consumer<SearchProgress> listener) {
        var adaptation = CovarianceMatrixAdaptation.plain(start, plan.step(), plan.population(), plan.seed());
        for (int i = 0; i < plan.generations(); i++) {
            List<double[]> candidates = adaptation.ask();
            double[] costs = costs(candidates, i / plan.keepTrials());
            adaptation.tell(costs);
            double least = Arrays.stream(costs).min().orElseThrow();
            double mean = Arrays.stream(costs).average().orElseThrow();
            listener.accept(new SearchProgress(i, least, mean, adaptation.step(), adaptation.mean()));
        }
        return adaptation.mean();
    }

    private double[] costs(List<double[]> candidates, int epoch) {
        int trials = plan.trials();
        double[] all = IntStream.range(0, candidates.size() * trials)
                .parallel()
                .mapToDouble(i -> trial.cost(candidates.get(i / trials), seed(epoch, i % trials)))
                .toArray();
        return IntStream.range(0, candidates.size())
                .mapToDouble(i -> RiskAverseMean.of(Arrays.copyOfRange(all, i * trials, (i + 1) * trials)))
                .toArray();
    }

    private long seed(int epoch, int number) {
        return plan.seed() * 1_000_000 + epoch * 1000L + number;
    }
}
