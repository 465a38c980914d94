package org.robonewbie.learning.search;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/**
 * Searches by {@link CovarianceMatrixAdaptation}, and begins again at the start when a run has come to its end, since a search
 * that narrows down may have done so around the wrong place. The new run has either twice as many candidates as the largest
 * one before, which sees the whole landscape rather than its bumps, or few candidates close together, which is quick; both kinds get equal
 * numbers of trials (BIPOP).
 *
 * <p>Source: N. Hansen, Benchmarking a BI-Population CMA-ES on the BBOB-2009 Function Testbed (2009).
 */
public final class RestartingSearch implements AskAndTell {

    private final double[] start;
    private final double step;
    private final int population;
    private final Random random;

    private CovarianceMatrixAdaptation run;
    private StoppingCriterion standstill;
    private boolean isLarge = true;
    private int largestPopulation;
    private long trialsOfLarge;
    private long trialsOfSmall;
    private long trialsOfRun;
    private int restarts;
    private Optional<Ended> bestEnded = Optional.empty();
    private double lastCost = Double.POSITIVE_INFINITY;

    /** The centre of a run that has ended, and what its last candidates cost in the mean. */
    @SuppressWarnings("ArrayRecordComponent")
    private record Ended(double[] mean, double cost) {}

    /**
     * Starts a search.
     *
     * @param start the centre of the first cloud; all coordinates should be of similar size
     * @param step the spread of the first cloud in each coordinate, greater than 0
     * @param population how many candidates the first run draws at a time, at least 4
     * @param seed the same seed gives the same candidates for the same costs
     */
    public RestartingSearch(double[] start, double step, int population, long seed) {
        this.start = start.clone();
        this.step = step;
        this.population = population;
        this.largestPopulation = population;
        this.random = new Random(seed);
        this.run = new CovarianceMatrixAdaptation(start, step, population, seed);
        this.standstill = new StoppingCriterion(start.length, population);
    }

    /**
     * {@inheritDoc}
     *
     * @return the points; how many they are changes when a new run begins
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
        standstill.note(costs);
        if (standstill.isReached(run.largestSpread() / step, run.condition()) || hasUsedUp()) {
            restart();
        }
    }

    /** Runs with few candidates take no more trials, all together, than the large ones have taken. */
    private boolean hasUsedUp() {
        return !isLarge && trialsOfSmall + trialsOfRun > trialsOfLarge;
    }

    private void restart() {
        bestEnded = Optional.of(best());
        if (isLarge) {
            trialsOfLarge += trialsOfRun;
        } else {
            trialsOfSmall += trialsOfRun;
        }
        trialsOfRun = 0;
        restarts++;
        isLarge = trialsOfSmall >= trialsOfLarge;
        if (isLarge) {
            largestPopulation *= 2;
            begin(largestPopulation, step);
        } else {
            double share = random.nextDouble();
            int few = (int) (population * Math.pow(largestPopulation / 2.0 / population, share * share));
            begin(Math.max(4, few), step * Math.pow(10, -2 * random.nextDouble()));
        }
    }

    private void begin(int candidates, double firstStep) {
        run = new CovarianceMatrixAdaptation(start, firstStep, candidates, random.nextLong());
        standstill = new StoppingCriterion(start.length, candidates);
        lastCost = Double.POSITIVE_INFINITY;
    }

    private Ended best() {
        return bestEnded.filter(ended -> ended.cost() <= lastCost).orElseGet(() -> new Ended(run.mean(), lastCost));
    }

    /** {@return a copy of the centre of the best run so far} */
    @Override
    public double[] mean() {
        return best().mean().clone();
    }

    @Override
    public CovarianceMatrixAdaptation distribution() {
        return run;
    }

    /** {@return how often the search has begun again} */
    public int restarts() {
        return restarts;
    }
}
