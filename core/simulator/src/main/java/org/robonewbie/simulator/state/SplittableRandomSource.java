package org.robonewbie.simulator.state;

import java.util.random.RandomGenerator;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * Restorable equivalent of {@link java.util.SplittableRandom}: the same seed produces the same sequence of {@code long}
 * and {@code double} values. Values of other types differ from the JDK's.
 *
 * <p>Source: SplitMix64 in Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (OOPSLA 2014).
 */
public final class SplittableRandomSource implements RandomGenerator, Restorable {

    private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;

    private long state;

    /**
     * Creates a generator.
     *
     * @param seed seed of the sequence
     */
    public SplittableRandomSource(long seed) {
        state = seed;
    }

    @Override
    public long nextLong() {
        state += GOLDEN_GAMMA;
        long mixed = (state ^ (state >>> 30)) * 0xBF58476D1CE4E5B9L;
        mixed = (mixed ^ (mixed >>> 27)) * 0x94D049BB133111EBL;
        return mixed ^ (mixed >>> 31);
    }

    @Override
    public double nextDouble() {
        return (nextLong() >>> 11) * 0x1.0p-53;
    }

    @Override
    public void save(StateWriter out) {
        out.putLong(state);
    }

    @Override
    public void restore(StateReader in) {
        state = in.getLong();
    }
}
