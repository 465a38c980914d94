package org.robonewbie.trial;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** Source of the random numbers for a scene, determined by the seed of the trial. */
public final class RandomSource {

    private final long seed;
    private final Random random;

    /**
     * Creates the source for a trial.
     *
     * @param seed the seed of the trial
     */
    public RandomSource(long seed) {
        this.seed = seed;
        this.random = new Random(31 * seed + 17);
    }

    /** {@return the seed of the trial} */
    public long seed() {
        return seed;
    }

    /**
     * Draws a uniformly distributed number.
     *
     * @param min lower bound, inclusive
     * @param max upper bound, exclusive
     * @return the number
     */
    public double between(double min, double max) {
        return min + (max - min) * random.nextDouble();
    }

    /** {@return 1 or -1 with equal probability} */
    public int side() {
        return random.nextBoolean() ? 1 : -1;
    }

    /** {@return whether the seed is odd, for properties that alternate from one seed to the next} */
    public boolean isSeedOdd() {
        return seed % 2 != 0;
    }

    /**
     * Shuffles a list.
     *
     * @param elements the elements
     * @param <T> type of the elements
     * @return the elements in random order
     */
    public <T> List<T> shuffled(List<T> elements) {
        List<T> all = new ArrayList<>(elements);
        Collections.shuffle(all, random);
        return List.copyOf(all);
    }
}
