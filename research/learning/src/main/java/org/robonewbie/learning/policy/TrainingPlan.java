package org.robonewbie.learning.policy;

import java.util.List;
import java.util.Locale;

/**
 * How long and with what somebody learns.
 *
 * @param seed the same seed gives the same policy
 * @param generations how many generations there are
 * @param pairs how many pairs of candidates a generation has
 * @param spread standard deviation of the candidates
 * @param rate how far the answer moves in a generation
 * @param seconds length of a lesson
 * @param newtons strength of the hardest pushes
 * @param options what is different in the episodes of a task, such as {@code noise=0.5}
 * @param threads how many lessons are given at the same time; the result does not depend on it
 */
public record TrainingPlan(
        long seed,
        int generations,
        int pairs,
        double spread,
        double rate,
        double seconds,
        double newtons,
        List<String> options,
        int threads) {

    /**
     * Checks the numbers and copies the list.
     *
     * @throws IllegalArgumentException if one is too small
     */
    public TrainingPlan {
        options = List.copyOf(options);
        if (generations < 1 || pairs < 1 || threads < 1 || !(spread > 0 && rate > 0 && seconds > 0) || newtons < 0) {
            throw new IllegalArgumentException("Generations, pairs, threads, spread, rate and seconds have to be"
                    + " greater than 0, and newtons not below.");
        }
    }

    /** {@return how somebody learns, in words that can be given again; the number of generations only says where it ends} */
    public String words() {
        return String.format(Locale.ROOT, "--seed %d --pairs %d --spread %s --rate %s", seed, pairs, spread, rate);
    }

    EvolutionStrategy strategy() {
        return new EvolutionStrategy(seed, pairs, spread, rate);
    }
}
