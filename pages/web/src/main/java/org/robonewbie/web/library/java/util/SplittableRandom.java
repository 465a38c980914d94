package org.robonewbie.web.library.java.util;

import java.util.random.RandomGenerator;

/** Subset of {@link java.util.SplittableRandom} for the simulator, with the same sequence for the same seed. */
public final class SplittableRandom implements RandomGenerator {

    private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;
    private static final int MIN_BIT_CHANGES = 24;

    private final long gamma;
    private long state;

    /**
     * Creates a generator.
     *
     * @param seed the seed
     */
    public SplittableRandom(long seed) {
        this(seed, GOLDEN_GAMMA);
    }

    private SplittableRandom(long state, long gamma) {
        this.state = state;
        this.gamma = gamma;
    }

    /** {@return a statistically independent generator} */
    public SplittableRandom split() {
        return new SplittableRandom(nextLong(), mixedGamma(nextState()));
    }

    private long nextState() {
        state += gamma;
        return state;
    }

    @Override
    public long nextLong() {
        long next = nextState();
        long mixed = (next ^ (next >>> 30)) * 0xBF58476D1CE4E5B9L;
        mixed = (mixed ^ (mixed >>> 27)) * 0x94D049BB133111EBL;
        return mixed ^ (mixed >>> 31);
    }

    @Override
    public double nextDouble() {
        return (nextLong() >>> 11) * 0x1.0p-53;
    }

    private static long mixedGamma(long next) {
        long mixed = (next ^ (next >>> 33)) * 0xFF51AFD7ED558CCDL;
        mixed = (mixed ^ (mixed >>> 33)) * 0xC4CEB9FE1A85EC53L;
        mixed = (mixed ^ (mixed >>> 33)) | 1;
        return Long.bitCount(mixed ^ (mixed >>> 1)) < MIN_BIT_CHANGES ? mixed ^ 0xAAAAAAAAAAAAAAAAL : mixed;
    }
}
