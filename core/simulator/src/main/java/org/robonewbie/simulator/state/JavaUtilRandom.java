package org.robonewbie.simulator.state;

import java.util.random.RandomGenerator;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * The random numbers of {@link java.util.Random}, whose state cannot be read: a seed gives the very same sequence.
 *
 * <p>The documentation of {@code java.util.Random} specifies all of its numbers: a linear congruential generator of 48 bits
 * (D. H. Lehmer; Knuth, The Art of Computer Programming 2, section 3.2.1), of which the upper bits are used.
 */
public final class JavaUtilRandom implements RandomGenerator, Restorable {

    private static final long MULTIPLIER = 0x5DEECE66DL;
    private static final long INCREMENT = 0xB;
    private static final int BITS = 48;
    private static final long MASK = (1L << BITS) - 1;

    private long state;

    /**
     * Begins a sequence.
     *
     * @param seed which sequence
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
