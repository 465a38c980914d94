package org.robonewbie.learning.policy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.robonewbie.nao.math.PortableMath;

/**
 * An evolution strategy for hundreds of numbers (Salimans et al. 2017): each generation tries pairs of candidates, which lie at
 * opposite sides of the mean, and moves the mean towards the better ones. Candidates count by their rank only, and steps are
 * evened out by Adam (Kingma and Ba 2015). What comes next depends on seed, mean and moments alone, so that a training goes on
 * exactly where it was interrupted.
 *
 * <pre>{@code
 * List<double[]> candidates = strategy.ask(state);
 * state = strategy.tell(state, scores);
 * }</pre>
 *
 * @param seed chooses the candidates
 * @param pairs how many pairs of candidates a generation has
 * @param spread standard deviation of the candidates, in units
 * @param rate how far the mean moves in a generation, in units
 */
public record EvolutionStrategy(long seed, int pairs, double spread, double rate) {

    private static final double MEMORY = 0.9;
    private static final double SQUARES_MEMORY = 0.99;
    private static final double TINY = 1e-8;

    /**
     * Where a training is.
     *
     * @param generation how many generations have been tried
     * @param mean the answer so far
     * @param units by how much each number is usually changed
     * @param drift mean of the last steps
     * @param squares mean of their squares
     */
    @SuppressWarnings("ArrayRecordComponent")
    public record State(int generation, double[] mean, double[] units, double[] drift, double[] squares) {

        /**
         * Begins.
         *
         * @param mean the first guess
         * @param units by how much each number is usually changed
         * @return the state before the first generation
         */
        public static State begin(double[] mean, double[] units) {
            return new State(0, mean, units, new double[mean.length], new double[mean.length]);
        }
    }

    /**
     * Draws the candidates of the next generation.
     *
     * @param state where the training is
     * @return two for each pair, one after the other
     */
    public List<double[]> ask(State state) {
        List<double[]> candidates = new ArrayList<>();
        for (double[] noise : noise(state)) {
            candidates.add(moved(state, noise, spread));
            candidates.add(moved(state, noise, -spread));
        }
        return candidates;
    }

    /**
     * Chooses the trial of a candidate; both of a pair get the same one.
     *
     * @param state where the training is
     * @param candidate its index
     * @return the seed of its trial
     */
    public long seedOfTrial(State state, int candidate) {
        return new Random(mixed(state) + 7919L * (candidate / 2 + 1)).nextInt(Integer.MAX_VALUE);
    }

    /**
     * Learns from the candidates.
     *
     * @param state where the training was when they were asked for
     * @param scores how good each was; more is better
     * @return where the training is now
     */
    public State tell(State state, double... scores) {
        double[] gradient = gradient(state, ranks(scores));
        int size = gradient.length;
        double[] mean = state.mean().clone();
        double[] drift = new double[size];
        double[] squares = new double[size];
        int generation = state.generation() + 1;
        for (int i = 0; i < size; i++) {
            drift[i] = MEMORY * state.drift()[i] + (1 - MEMORY) * gradient[i];
            squares[i] = SQUARES_MEMORY * state.squares()[i] + (1 - SQUARES_MEMORY) * gradient[i] * gradient[i];
            double way = drift[i] / (1 - PortableMath.pow(MEMORY, generation));
            double evened = squares[i] / (1 - PortableMath.pow(SQUARES_MEMORY, generation));
            mean[i] += rate * state.units()[i] * way / (Math.sqrt(evened) + TINY);
        }
        return new State(generation, mean, state.units(), drift, squares);
    }

    private double[] gradient(State state, double... ranks) {
        double[] gradient = new double[state.mean().length];
        List<double[]> noise = noise(state);
        for (int k = 0; k < pairs; k++) {
            double weight = (ranks[2 * k] - ranks[2 * k + 1]) / pairs;
            for (int i = 0; i < gradient.length; i++) {
                gradient[i] += weight * noise.get(k)[i];
            }
        }
        return gradient;
    }

    /** From -0.5 for the worst to 0.5 for the best. */
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
        for (int k = 0; k < pairs; k++) {
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
            candidate[i] += distance * state.units()[i] * noise[i];
        }
        return candidate;
    }
}
