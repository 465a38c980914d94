package org.robonewbie.learning.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntUnaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxEval;
import org.hipparchus.optim.SimpleBounds;
import org.hipparchus.optim.nonlinear.scalar.GoalType;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.scalar.noderiv.CMAESOptimizer;
import org.hipparchus.random.MersenneTwister;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Our search and that of Hipparchus need about the same number of trials, in the median over several seeds. */
class HipparchusComparisonTest {

    private static final int DIMENSION = 8;
    private static final int POPULATION = 10;
    private static final int SEEDS = 9;
    private static final int MAX_TRIALS = 40_000;
    private static final double GOOD = 1e-8;

    enum Function {
        SPHERE,
        ELLIPSOID,
        ROSENBROCK;

        double cost(double[] x) {
            return switch (this) {
                case SPHERE -> Arrays.stream(x).map(v -> v * v).sum();
                case ELLIPSOID ->
                    IntStream.range(0, x.length)
                            .mapToDouble(i -> Math.pow(1e6, i / (x.length - 1.0)) * x[i] * x[i])
                            .sum();
                case ROSENBROCK ->
                    IntStream.range(0, x.length - 1)
                            .mapToDouble(i -> 100 * Math.pow(x[i + 1] - x[i] * x[i], 2) + Math.pow(1 - x[i], 2))
                            .sum();
            };
        }
    }

    @ParameterizedTest
    @EnumSource
    void plainSearchNeedsNoMoreTrialsThanTheLibrary(Function function) {
        double ours =
                median(seed -> ours(CovarianceMatrixAdaptation.plain(start(), 0.5, POPULATION, seed), function::cost));
        double theirs = median(seed -> theirs(false, function::cost, seed));

        assertThat(ours).isBetween(0.6 * theirs, 1.25 * theirs);
    }

    @ParameterizedTest
    @EnumSource
    void activeSearchNeedsNoMoreTrialsThanTheLibrary(Function function) {
        double ours =
                median(seed -> ours(new CovarianceMatrixAdaptation(start(), 0.5, POPULATION, seed), function::cost));
        double theirs = median(seed -> theirs(true, function::cost, seed));

        assertThat(ours).isBetween(0.6 * theirs, 1.25 * theirs);
    }

    private static double median(IntUnaryOperator trials) {
        int[] sorted = IntStream.range(1, SEEDS + 1).map(trials).sorted().toArray();
        return sorted[SEEDS / 2];
    }

    private static int ours(AskAndTell search, ToDoubleFunction<double[]> cost) {
        Counter counter = new Counter(cost);
        while (counter.firstGood == 0 && counter.trials < MAX_TRIALS) {
            List<double[]> candidates = search.ask();
            search.tell(candidates.stream().mapToDouble(counter::value).toArray());
        }
        return counter.result();
    }

    private static int theirs(boolean isActive, ToDoubleFunction<double[]> cost, int seed) {
        Counter counter = new Counter(cost);
        var optimizer = new CMAESOptimizer(
                MAX_TRIALS, GOOD, isActive, 0, 0, new MersenneTwister(seed), false, (iteration, before, now) -> false);
        double[] spread = new double[DIMENSION];
        Arrays.fill(spread, 0.5);
        optimizer.optimize(
                new MaxEval(MAX_TRIALS),
                new ObjectiveFunction(counter::value),
                GoalType.MINIMIZE,
                new InitialGuess(start()),
                SimpleBounds.unbounded(DIMENSION),
                new CMAESOptimizer.Sigma(spread),
                new CMAESOptimizer.PopulationSize(POPULATION));
        return counter.result();
    }

    private static double[] start() {
        double[] start = new double[DIMENSION];
        Arrays.fill(start, -0.5);
        return start;
    }

    /** Counts trials until the first good one. */
    private static final class Counter {

        private final ToDoubleFunction<double[]> cost;
        private int trials;
        private int firstGood;

        Counter(ToDoubleFunction<double[]> cost) {
            this.cost = cost;
        }

        double value(double[] point) {
            trials++;
            double value = cost.applyAsDouble(point);
            if (value < GOOD && firstGood == 0) {
                firstGood = trials;
            }
            return value;
        }

        int result() {
            return firstGood == 0 ? MAX_TRIALS : firstGood;
        }
    }
}
