package org.robonewbie.learning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * Finds numbers with a small cost by drawing candidates from a distribution that moves, stretches and rotates towards the
 * better ones (CMA-ES). It needs no derivatives and copes with noisy, bumpy costs such as "how far did the robot walk".
 *
 * <p>Source: N. Hansen, The CMA Evolution Strategy: A Tutorial (2016), with its default constants.
 *
 * <pre>{@code
 * var search = new CovarianceMatrixAdaptation(new double[] {3, 4}, 0.5, 12, 1);
 * for (int i = 0; i < 100; i++) {
 *   double[] costs = search.ask().stream().mapToDouble(p -> p[0] * p[0] + p[1] * p[1]).toArray();
 *   search.tell(costs);
 * }
 * }</pre>
 */
public final class CovarianceMatrixAdaptation {

    private final int dimension;
    private final int population;
    private final Random random;
    private final double[] weights;
    private final double effectiveParents;
    private final double pathDecay;
    private final double stepDecay;
    private final double rankOneRate;
    private final double rankManyRate;
    private final double damping;
    private final double expectedLength;

    private final double[] mean;
    private final double[] path;
    private final double[] stepPath;
    private final double[][] covariance;
    private SymmetricMatrix decomposed;
    private double step;
    private int generation;
    private final List<double[]> candidates = new ArrayList<>();
    private double[] best;
    private double bestCost = Double.POSITIVE_INFINITY;

    /**
     * Starts a search.
     *
     * @param start the centre of the first cloud; all coordinates should be of similar size
     * @param step the spread of the first cloud in each coordinate, greater than 0
     * @param population how many candidates are drawn at a time, at least 4
     * @param seed the same seed gives the same candidates for the same costs
     */
    public CovarianceMatrixAdaptation(double[] start, double step, int population, long seed) {
        if (start.length == 0 || step <= 0 || population < 4) {
            throw new IllegalArgumentException("A search needs at least one coordinate, a step greater than 0 and a"
                    + " population of at least 4. Given: " + start.length + " coordinates, step " + step
                    + ", population " + population);
        }
        this.dimension = start.length;
        this.population = population;
        this.step = step;
        this.random = new Random(seed);
        this.mean = start.clone();
        this.best = start.clone();
        this.weights = parentWeights(population / 2);
        double n = dimension;
        double parents = 1 / Arrays.stream(weights).map(w -> w * w).sum();
        this.effectiveParents = parents;
        this.stepDecay = (parents + 2) / (n + parents + 5);
        this.pathDecay = (4 + parents / n) / (n + 4 + 2 * parents / n);
        this.rankOneRate = 2 / ((n + 1.3) * (n + 1.3) + parents);
        this.rankManyRate = Math.min(1 - rankOneRate, 2 * (parents - 2 + 1 / parents) / ((n + 2) * (n + 2) + parents));
        this.damping = 1 + 2 * Math.max(0, Math.sqrt((parents - 1) / (n + 1)) - 1) + stepDecay;
        this.expectedLength = Math.sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
        this.path = new double[dimension];
        this.stepPath = new double[dimension];
        this.covariance = new double[dimension][dimension];
        for (int i = 0; i < dimension; i++) {
            covariance[i][i] = 1;
        }
        this.decomposed = SymmetricMatrix.decompose(covariance);
    }

    /**
     * Draws the next candidates.
     *
     * @return as many points as the population is large; their costs are wanted by {@link #tell}
     */
    public List<double[]> ask() {
        candidates.clear();
        for (int i = 0; i < population; i++) {
            candidates.add(draw());
        }
        return candidates.stream().map(double[]::clone).toList();
    }

    /**
     * Learns from the costs of the last candidates.
     *
     * @param costs one cost for each candidate of {@link #ask}, in the same order; smaller is better, NaN is worst
     */
    public void tell(double[] costs) {
        if (costs.length != candidates.size() || costs.length == 0) {
            throw new IllegalArgumentException(costs.length + " costs for " + candidates.size()
                    + " candidates. Call ask() first, then tell() once.");
        }
        List<double[]> parents = IntStream.range(0, population)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer i) -> rank(costs[i])))
                .limit(weights.length)
                .map(candidates::get)
                .toList();
        rememberBest(costs);
        double[] before = mean.clone();
        moveMean(parents);
        updatePaths(before);
        updateCovariance(parents, before);
        updateStep();
        candidates.clear();
        generation++;
        decomposed = SymmetricMatrix.decompose(covariance);
    }

    /** {@return a copy of the mean of the distribution; with noisy costs it is a better answer than {@link #best}} */
    public double[] mean() {
        return mean.clone();
    }

    /** {@return a copy of the candidate with the smallest cost so far; the start before the first {@link #tell}} */
    public double[] best() {
        return best.clone();
    }

    /** {@return the smallest cost so far, that of {@link #best}; infinite before the first {@link #tell}} */
    public double bestCost() {
        return bestCost;
    }

    /** {@return the present step size; the search is over when it is tiny} */
    public double step() {
        return step;
    }

    /** {@return the standard deviation of the next candidates in each coordinate, all greater than 0} */
    public double[] spread() {
        return IntStream.range(0, dimension)
                .mapToDouble(i -> step * Math.sqrt(covariance[i][i]))
                .toArray();
    }

    private static double[] parentWeights(int parents) {
        double[] raw = IntStream.rangeClosed(1, parents)
                .mapToDouble(i -> Math.log(parents + 0.5) - Math.log(i))
                .toArray();
        double sum = Arrays.stream(raw).sum();
        return Arrays.stream(raw).map(w -> w / sum).toArray();
    }

    private static double rank(double cost) {
        return Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost;
    }

    private double[] draw() {
        double[] point = mean.clone();
        for (int j = 0; j < dimension; j++) {
            double length = step * Math.sqrt(Math.max(0, decomposed.value(j))) * random.nextGaussian();
            for (int i = 0; i < dimension; i++) {
                point[i] += length * decomposed.axis(i, j);
            }
        }
        return point;
    }

    private void rememberBest(double[] costs) {
        for (int i = 0; i < costs.length; i++) {
            if (costs[i] < bestCost) {
                bestCost = costs[i];
                best = candidates.get(i).clone();
            }
        }
    }

    private void moveMean(List<double[]> parents) {
        Arrays.fill(mean, 0);
        for (int k = 0; k < weights.length; k++) {
            for (int i = 0; i < dimension; i++) {
                mean[i] += weights[k] * parents.get(k)[i];
            }
        }
    }

    private void updatePaths(double[] before) {
        double[] move = new double[dimension];
        for (int i = 0; i < dimension; i++) {
            move[i] = (mean[i] - before[i]) / step;
        }
        double[] whitened = whiten(move);
        double stepGain = Math.sqrt(stepDecay * (2 - stepDecay) * effectiveParents);
        for (int i = 0; i < dimension; i++) {
            stepPath[i] = (1 - stepDecay) * stepPath[i] + stepGain * whitened[i];
        }
        double pathGain = isStepPathShort() ? Math.sqrt(pathDecay * (2 - pathDecay) * effectiveParents) : 0;
        for (int i = 0; i < dimension; i++) {
            path[i] = (1 - pathDecay) * path[i] + pathGain * move[i];
        }
    }

    private double[] whiten(double[] vector) {
        double[] result = new double[dimension];
        for (int j = 0; j < dimension; j++) {
            double along = 0;
            for (int i = 0; i < dimension; i++) {
                along += decomposed.axis(i, j) * vector[i];
            }
            along /= Math.sqrt(Math.max(1e-300, decomposed.value(j)));
            for (int i = 0; i < dimension; i++) {
                result[i] += along * decomposed.axis(i, j);
            }
        }
        return result;
    }

    private boolean isStepPathShort() {
        double settled = 1 - Math.pow(1 - stepDecay, 2.0 * (generation + 1));
        return length(stepPath) / Math.sqrt(settled) < (1.4 + 2.0 / (dimension + 1)) * expectedLength;
    }

    private void updateCovariance(List<double[]> parents, double[] before) {
        double lost = isStepPathShort() ? 0 : rankOneRate * pathDecay * (2 - pathDecay);
        double keep = 1 - rankOneRate - rankManyRate + lost;
        for (int i = 0; i < dimension; i++) {
            for (int j = 0; j <= i; j++) {
                double many = 0;
                for (int k = 0; k < weights.length; k++) {
                    double[] parent = parents.get(k);
                    many += weights[k] * (parent[i] - before[i]) * (parent[j] - before[j]) / (step * step);
                }
                double value = keep * covariance[i][j] + rankOneRate * path[i] * path[j] + rankManyRate * many;
                covariance[i][j] = value;
                covariance[j][i] = value;
            }
        }
    }

    private void updateStep() {
        step *= Math.exp(Math.min(1, stepDecay / damping * (length(stepPath) / expectedLength - 1)));
    }

    private static double length(double[] vector) {
        return Math.sqrt(Arrays.stream(vector).map(v -> v * v).sum());
    }
}
