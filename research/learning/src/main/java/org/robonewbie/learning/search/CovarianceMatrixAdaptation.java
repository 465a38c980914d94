package org.robonewbie.learning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * Covariance matrix adaptation evolution strategy (CMA-ES): minimises a cost function without derivatives, even if it is
 * noisy and multimodal, such as the distance that a robot walks.
 *
 * <p>By default, the search also learns from the worse half of a generation through negative recombination weights (active CMA-ES), which
 * saves a fifth to a third of the evaluations on ill-conditioned problems. {@link #plain} uses no negative weights.
 *
 * <p>Source: N. Hansen, The CMA Evolution Strategy: A Tutorial (2016), with its default constants and equation numbers.
 *
 * <pre>{@code
 * var search = new CovarianceMatrixAdaptation(new double[] {3, 4}, 0.5, 12, 1);
 * for (int i = 0; i < 100; i++) {
 *   double[] costs = search.ask().stream().mapToDouble(p -> p[0] * p[0] + p[1] * p[1]).toArray();
 *   search.tell(costs);
 * }
 * }</pre>
 */
public final class CovarianceMatrixAdaptation implements AskAndTell {

    /** Offset in the rank-mu learning rate (equation 58) that keeps it positive for a population of 4. */
    private static final double ACTIVE_OFFSET = 0.25;

    private final int dimension;
    private final int population;
    private final Random random;
    private final double[] weights;
    private final double[] negativeWeights;
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

    /**
     * Creates a search with active CMA-ES.
     *
     * @param start the initial mean; all coordinates should have similar scales
     * @param step the initial step size (sigma), greater than 0
     * @param population the number of candidates in a generation, at least 4
     * @param seed the seed for drawing candidates
     */
    public CovarianceMatrixAdaptation(double[] start, double step, int population, long seed) {
        this(start, step, population, seed, true);
    }

    /**
     * Creates a search without negative weights, as used for the shipped motions.
     *
     * @param start the initial mean; all coordinates should have similar scales
     * @param step the initial step size (sigma), greater than 0
     * @param population the number of candidates in a generation, at least 4
     * @param seed the seed for drawing candidates
     * @return the search
     */
    public static CovarianceMatrixAdaptation plain(double[] start, double step, int population, long seed) {
        return new CovarianceMatrixAdaptation(start, step, population, seed, false);
    }

    /**
     * Returns the default population size (equation 48).
     *
     * @param dimension the number of coordinates
     * @return 4 + 3 ln(dimension), rounded down
     */
    public static int defaultPopulation(int dimension) {
        return 4 + (int) (3 * Math.log(dimension));
    }

    private CovarianceMatrixAdaptation(double[] start, double step, int population, long seed, boolean isActive) {
        if (start.length == 0 || step <= 0 || population < 4) {
            throw new IllegalArgumentException("A search needs at least one coordinate, a step greater than 0 and a"
                    + " population of at least 4, not " + start.length + " coordinates, step " + step
                    + " and population " + population + ".");
        }
        this.dimension = start.length;
        this.population = population;
        this.step = step;
        this.random = new Random(seed);
        this.mean = start.clone();
        this.weights = parentWeights(population / 2);
        double n = dimension;
        double parents = 1 / Arrays.stream(weights).map(w -> w * w).sum();
        this.effectiveParents = parents;
        this.stepDecay = (parents + 2) / (n + parents + 5);
        this.pathDecay = (4 + parents / n) / (n + 4 + 2 * parents / n);
        this.rankOneRate = 2 / ((n + 1.3) * (n + 1.3) + parents);
        double offset = isActive ? ACTIVE_OFFSET : 0;
        this.rankManyRate =
                Math.min(1 - rankOneRate, 2 * (parents - 2 + 1 / parents + offset) / ((n + 2) * (n + 2) + parents));
        this.negativeWeights = isActive ? negativeWeights() : new double[0];
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

    @Override
    public List<double[]> ask() {
        candidates.clear();
        for (int i = 0; i < population; i++) {
            candidates.add(draw());
        }
        return candidates.stream().map(double[]::clone).toList();
    }

    @Override
    public void tell(double[] costs) {
        if (costs.length != candidates.size() || costs.length == 0) {
            throw new IllegalArgumentException(costs.length + " costs for " + candidates.size()
                    + " candidates. Call tell() once after each ask().");
        }
        List<double[]> ranked = IntStream.range(0, population)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer i) -> rank(costs[i])))
                .map(candidates::get)
                .toList();
        double[] before = mean.clone();
        moveMean(ranked);
        updatePaths(before);
        updateCovariance(ranked, before);
        updateStep();
        candidates.clear();
        generation++;
        decomposed = SymmetricMatrix.decompose(covariance);
    }

    @Override
    public double[] mean() {
        return mean.clone();
    }

    /** {@return the current step size (sigma), which approaches 0 as the search converges} */
    public double step() {
        return step;
    }

    /** {@return the standard deviation of the next candidates in each coordinate, greater than 0} */
    public double[] spread() {
        return IntStream.range(0, dimension)
                .mapToDouble(i -> step * Math.sqrt(covariance[i][i]))
                .toArray();
    }

    /** Returns the standard deviation of the next candidates along the longest principal axis. */
    double maxSpread() {
        return step * Math.sqrt(eigenvalues().max().orElseThrow());
    }

    /** Returns the condition number of the covariance matrix. */
    double condition() {
        return eigenvalues().max().orElseThrow()
                / Math.max(Double.MIN_NORMAL, eigenvalues().min().orElseThrow());
    }

    private DoubleStream eigenvalues() {
        return IntStream.range(0, dimension).mapToDouble(decomposed::value);
    }

    @Override
    public CovarianceMatrixAdaptation distribution() {
        return this;
    }

    private static double[] parentWeights(int parents) {
        double[] raw = IntStream.rangeClosed(1, parents)
                .mapToDouble(i -> Math.log(parents + 0.5) - Math.log(i))
                .toArray();
        double sum = Arrays.stream(raw).sum();
        return Arrays.stream(raw).map(w -> w / sum).toArray();
    }

    /**
     * Returns the weights of the worse half, scaled so that the covariance stays positive definite (equations 49 to 53).
     */
    private double[] negativeWeights() {
        double[] raw = IntStream.rangeClosed(weights.length + 1, population)
                .mapToDouble(i -> Math.log(weights.length + 0.5) - Math.log(i))
                .toArray();
        double sum = -Arrays.stream(raw).sum();
        double effective = sum * sum / Arrays.stream(raw).map(w -> w * w).sum();
        double total = DoubleStream.of(
                        1 + rankOneRate / rankManyRate,
                        1 + 2 * effective / (effectiveParents + 2),
                        (1 - rankOneRate - rankManyRate) / (dimension * rankManyRate))
                .min()
                .orElseThrow();
        return Arrays.stream(raw).map(w -> w / sum * total).toArray();
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

    private void moveMean(List<double[]> ranked) {
        Arrays.fill(mean, 0);
        for (int k = 0; k < weights.length; k++) {
            for (int i = 0; i < dimension; i++) {
                mean[i] += weights[k] * ranked.get(k)[i];
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

    private void updateCovariance(List<double[]> ranked, double[] before) {
        double lost = isStepPathShort() ? 0 : rankOneRate * pathDecay * (2 - pathDecay);
        double keep = 1
                - rankOneRate
                - rankManyRate
                + lost
                - rankManyRate * Arrays.stream(negativeWeights).sum();
        List<double[]> parents = ranked.subList(0, weights.length);
        List<double[]> others = ranked.subList(weights.length, negativeWeights.length + weights.length);
        double[] scaled = scaledNegativeWeights(others, before);
        for (int i = 0; i < dimension; i++) {
            for (int j = 0; j <= i; j++) {
                double many = 0;
                for (int k = 0; k < weights.length; k++) {
                    double[] parent = parents.get(k);
                    many += weights[k] * (parent[i] - before[i]) * (parent[j] - before[j]) / (step * step);
                }
                for (int k = 0; k < scaled.length; k++) {
                    double[] other = others.get(k);
                    many += scaled[k] * (other[i] - before[i]) * (other[j] - before[j]);
                }
                double value = keep * covariance[i][j] + rankOneRate * path[i] * path[j] + rankManyRate * many;
                covariance[i][j] = value;
                covariance[j][i] = value;
            }
        }
    }

    /** Divides each negative weight by the squared Mahalanobis distance of its candidate (equation 46). */
    private double[] scaledNegativeWeights(List<double[]> others, double[] before) {
        return IntStream.range(0, others.size())
                .mapToDouble(k -> {
                    double[] move = IntStream.range(0, dimension)
                            .mapToDouble(i -> others.get(k)[i] - before[i])
                            .toArray();
                    double distance = length(whiten(move));
                    return negativeWeights[k] * dimension / Math.max(Double.MIN_NORMAL, distance * distance);
                })
                .toArray();
    }

    private void updateStep() {
        step *= Math.exp(Math.min(1, stepDecay / damping * (length(stepPath) / expectedLength - 1)));
    }

    private static double length(double[] vector) {
        return Math.sqrt(Arrays.stream(vector).map(v -> v * v).sum());
    }
}
