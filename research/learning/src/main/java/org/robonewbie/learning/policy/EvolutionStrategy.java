package org.robonewbie.learning.policy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.IntStream;
import org.robonewbie.nao.math.PortableMath;

/**
 * Evolution strategy for hundreds of parameters (Salimans et al., Evolution Strategies as a Scalable Alternative to
 * Reinforcement Learning, 2017), with antithetic sampling, rank-based fitness shaping and the Adam optimiser (Kingma and
 * Ba, 2015). The state determines the next generation, so an interrupted search resumes with the same result.
 *
 * <pre>{@code
 * List<double[]> candidates = strategy.ask(state);
 * state = strategy.tell(state, scores);
 * }</pre>
 *
 * @param seed the seed for drawing candidates
 * @param antitheticPairs the number of pairs of candidates in a generation, at least 1
 * @param sigma standard deviation of the candidates relative to the scale of each parameter, greater than 0
 * @param learningRate step size of Adam relative to the scale of each parameter, greater than 0
 */
public record EvolutionStrategy(long seed, int antitheticPairs, double sigma, double learningRate) {

    private static final double BETA_1 = 0.9;
    private static final double BETA_2 = 0.99;
    private static final double EPSILON = 1e-8;

    /** Validates the parameters. */
    public EvolutionStrategy {
        if (antitheticPairs < 1 || !(sigma > 0 && learningRate > 0)) {
            throw new IllegalArgumentException("Pairs, sigma and learning rate must be greater than 0.");
        }
    }

    /** Returns the options of {@code robonewbie learn} that create this strategy. */
    String commandLine() {
        return String.format(
                Locale.ROOT,
                "--seed %d --pairs %d --sigma %s --learning-rate %s",
                seed,
                antitheticPairs,
                sigma,
                learningRate);
    }

    /**
     * State of a search.
     *
     * @param generation the number of completed generations
     * @param mean the current solution
     * @param scale the scale of each parameter
     * @param firstMoment Adam's moving average of the gradient
     * @param secondMoment Adam's moving average of the squared gradient
     */
    @SuppressWarnings("ArrayRecordComponent")
    public record State(int generation, double[] mean, double[] scale, double[] firstMoment, double[] secondMoment) {

        /**
         * Creates the state before the first generation.
         *
         * @param mean the initial guess
         * @param scale the scale of each parameter
         * @return the state
         */
        public static State begin(double[] mean, double[] scale) {
            return new State(0, mean, scale, new double[mean.length], new double[mean.length]);
        }
    }

    /**
     * Draws the candidates of the next generation.
     *
     * @param state the state of the search
     * @return the candidates: pairs of opposite mutations, one pair after the other
     */
    public List<double[]> ask(State state) {
        List<double[]> candidates = new ArrayList<>();
        for (double[] noise : noise(state)) {
            candidates.add(moved(state, noise, sigma));
            candidates.add(moved(state, noise, -sigma));
        }
        return candidates;
    }

    /**
     * Returns the seed of a candidate's trial, which is the same for both candidates of a pair (common random numbers).
     *
     * @param state the state of the search
     * @param candidate the index of the candidate
     * @return the seed
     */
    public long seedOfTrial(State state, int candidate) {
        return new Random(mixed(state) + 7919L * (candidate / 2 + 1)).nextInt(Integer.MAX_VALUE);
    }

    /**
     * Updates the search with the scores of its candidates.
     *
     * @param state the state from which the candidates were drawn
     * @param scores the score of each candidate; larger is better
     * @return the next state
     */
    public State tell(State state, double... scores) {
        double[] gradient = gradient(state, ranks(scores));
        int size = gradient.length;
        double[] mean = state.mean().clone();
        double[] firstMoment = new double[size];
        double[] secondMoment = new double[size];
        int generation = state.generation() + 1;
        for (int i = 0; i < size; i++) {
            firstMoment[i] = BETA_1 * state.firstMoment()[i] + (1 - BETA_1) * gradient[i];
            secondMoment[i] = BETA_2 * state.secondMoment()[i] + (1 - BETA_2) * gradient[i] * gradient[i];
            double first = firstMoment[i] / (1 - PortableMath.pow(BETA_1, generation));
            double second = secondMoment[i] / (1 - PortableMath.pow(BETA_2, generation));
            mean[i] += learningRate * state.scale()[i] * first / (Math.sqrt(second) + EPSILON);
        }
        return new State(generation, mean, state.scale(), firstMoment, secondMoment);
    }

    private double[] gradient(State state, double... ranks) {
        double[] gradient = new double[state.mean().length];
        List<double[]> noise = noise(state);
        for (int k = 0; k < antitheticPairs; k++) {
            double weight = (ranks[2 * k] - ranks[2 * k + 1]) / antitheticPairs;
            for (int i = 0; i < gradient.length; i++) {
                gradient[i] += weight * noise.get(k)[i];
            }
        }
        return gradient;
    }

    /** Returns the centred ranks of scores, from -0.5 for the worst to 0.5 for the best. */
    private static double[] ranks(double... scores) {
        List<Integer> order = IntStream.range(0, scores.length)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> scores[i]))
                .toList();
        double[] ranks = new double[scores.length];
        for (int i = 0; i < ranks.length; i++) {
            ranks[order.get(i)] = (double) i / (ranks.length - 1) - 0.5;
        }
        return ranks;
    }

    private List<double[]> noise(State state) {
        Random random = new Random(mixed(state));
        List<double[]> noise = new ArrayList<>();
        for (int k = 0; k < antitheticPairs; k++) {
            double[] one = new double[state.mean().length];
            Arrays.setAll(one, i -> random.nextGaussian());
            noise.add(one);
        }
        return noise;
    }

    private long mixed(State state) {
        return 0x9E3779B97F4A7C15L * (seed + 1) + 0x632BE59BD9B4E019L * state.generation();
    }

    private static double[] moved(State state, double[] noise, double distance) {
        double[] candidate = state.mean().clone();
        for (int i = 0; i < candidate.length; i++) {
            candidate[i] += distance * state.scale()[i] * noise[i];
        }
        return candidate;
    }
}
