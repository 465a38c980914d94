package org.robonewbie.simulator.state;

import java.util.random.RandomGenerator;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * Restorable equivalent of {@link java.util.Random}: the same seed produces the same sequence.
 *
 * <p>48-bit linear congruential generator as specified by {@code java.util.Random} (D. H. Lehmer; Knuth, The Art of Computer
 * Programming 2, section 3.2.1).
 */
public final class JavaUtilRandom implements RandomGenerator, Restorable {

    private static final long MULTIPLIER = 0x5DEECE66DL;
    private static final long INCREMENT = 0xB;
    private static final int BITS = 48;
    private static final long MASK = (1L << BITS) - 1;

    private long state;

    /**
     * Creates a generator.
     *
     * @param seed seed of the sequence
     */
    public JavaUtilRandom(long seed) {
        state = (seed ^ MULTIPLIER) & MASK;
    }

    @Override
    public boolean nextBoolean() {
        return next(1) != 0;
    }

    @Override
    public int nextInt() {
        return next(Integer.SIZE);
    }

    @Override
    public long nextLong() {
        long high = (long) next(Integer.SIZE) << Integer.SIZE;
        return high + next(Integer.SIZE);
    }

    @Override
    public double nextDouble() {
        long high = (long) next(26) << 27;
        return (high + next(27)) * 0x1.0p-53;
    }

    @Override
    public void save(StateWriter out) {
        out.putLong(state);
    }

    @Override
    public void restore(StateReader in) {
        state = in.getLong() & MASK;
    }

    private int next(int bits) {
        state = (state * MULTIPLIER + INCREMENT) & MASK;
        return (int) (state >>> (BITS - bits));
    }
}
