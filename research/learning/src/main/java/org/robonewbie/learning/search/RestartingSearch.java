package org.robonewbie.learning.search;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/**
 * BIPOP-CMA-ES: restarts {@link CovarianceMatrixAdaptation} when a run has converged, because it may have found only a local
 * optimum. A restart uses either twice the largest population so far, which smooths over local optima, or a small population
 * and step size. Both kinds of restart get about the same number of evaluations.
 *
 * <p>Source: N. Hansen, Benchmarking a BI-Population CMA-ES on the BBOB-2009 Function Testbed (2009).
 */
public final class RestartingSearch implements AskAndTell {

    private final double[] start;
    private final double step;
    private final int population;
    private final Random random;

    private CovarianceMatrixAdaptation run;
    private StoppingCriterion stopping;
    private boolean isLarge = true;
    private int largestPopulation;
    private long trialsOfLarge;
    private long trialsOfSmall;
    private long trialsOfRun;
    private Optional<RunResult> bestCompleted = Optional.empty();
    private double lastCost = Double.POSITIVE_INFINITY;

    /** The final mean of a run, and the mean cost of its last generation. */
    @SuppressWarnings("ArrayRecordComponent")
    private record RunResult(double[] mean, double cost) {}

    /**
     * Creates a search.
     *
     * @param start the initial mean; all coordinates should have similar scales
     * @param step the initial step size (sigma), greater than 0
     * @param population the number of candidates in a generation of the first run, at least 4
     * @param seed the seed for drawing candidates
     */
    public RestartingSearch(double[] start, double step, int population, long seed) {
        this.start = start.clone();
        this.step = step;
        this.population = population;
        this.largestPopulation = population;
        this.random = new Random(seed);
        this.run = new CovarianceMatrixAdaptation(start, step, population, seed);
        this.stopping = new StoppingCriterion(start.length, population);
    }

    /**
     * {@inheritDoc}
     *
     * @return the points; their number may change after a restart
     */
    @Override
    public List<double[]> ask() {
        return run.ask();
    }

    @Override
    public void tell(double[] costs) {
        run.tell(costs);
        trialsOfRun += costs.length;
        double mean = Arrays.stream(costs).average().orElseThrow();
        lastCost = Double.isNaN(mean) ? Double.POSITIVE_INFINITY : mean;
        stopping.add(costs);
        if (stopping.isReached(run.maxSpread() / step, run.condition()) || isBudgetSpent()) {
            restart();
        }
    }

    /**
     * Returns whether a run with a small population must stop, because such runs have used more evaluations than those
     * with large populations.
     */
    private boolean isBudgetSpent() {
        return !isLarge && trialsOfSmall + trialsOfRun > trialsOfLarge;
    }

    private void restart() {
        bestCompleted = Optional.of(best());
        if (isLarge) {
            trialsOfLarge += trialsOfRun;
        } else {
            trialsOfSmall += trialsOfRun;
        }
        trialsOfRun = 0;
        isLarge = trialsOfSmall >= trialsOfLarge;
        if (isLarge) {
            largestPopulation *= 2;
            begin(largestPopulation, step);
        } else {
            double share = random.nextDouble();
            int small = (int) (population * Math.pow(largestPopulation / 2.0 / population, share * share));
            begin(Math.max(4, small), step * Math.pow(10, -2 * random.nextDouble()));
        }
    }

    private void begin(int candidates, double firstStep) {
        run = new CovarianceMatrixAdaptation(start, firstStep, candidates, random.nextLong());
        stopping = new StoppingCriterion(start.length, candidates);
        lastCost = Double.POSITIVE_INFINITY;
    }

    private RunResult best() {
        return bestCompleted
                .filter(completed -> completed.cost() <= lastCost)
                .orElseGet(() -> new RunResult(run.mean(), lastCost));
    }

    /** {@return a copy of the mean of the best run so far} */
    @Override
    public double[] mean() {
        return best().mean().clone();
    }

    @Override
    public CovarianceMatrixAdaptation distribution() {
        return run;
    }
}
