package org.robonewbie.trial;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** What is left to chance in a scene: numbers that are the same for the same seed. */
public final class RandomSource {

    private final long seed;
    private final Random random;

    /**
     * Creates the numbers of a trial.
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
     * Draws a number.
     *
     * @param least at least this
     * @param most less than this
     * @return a number between them, each as likely as the others
     */
    public double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    /** {@return 1 or -1, each as likely as the other} */
    public int side() {
        return random.nextBoolean() ? 1 : -1;
    }

    /** {@return whether the seed is odd, which alternates from trial to trial} */
    public boolean isSeedOdd() {
        return seed % 2 != 0;
    }

    /**
     * Shuffles things.
     *
     * @param things the things
     * @param <T> their type
     * @return the same things in random order
     */
    public <T> List<T> shuffled(List<T> things) {
        List<T> all = new ArrayList<>(things);
        Collections.shuffle(all, random);
        return List.copyOf(all);
    }
}
