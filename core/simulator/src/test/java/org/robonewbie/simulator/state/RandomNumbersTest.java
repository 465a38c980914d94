package org.robonewbie.simulator.state;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

class RandomNumbersTest {

    private static final long[] SEEDS = {0, 1, -1, 42, Long.MIN_VALUE, 0x5DEECE66DL, 987_654_321_987L};

    private static void assertSameNumbers(RandomGenerator ours, RandomGenerator theirs) {
        for (int i = 0; i < 2000; i++) {
            switch (i % 4) {
                case 0 -> assertThat(ours.nextLong()).isEqualTo(theirs.nextLong());
                case 1 -> assertThat(ours.nextDouble()).isEqualTo(theirs.nextDouble());
                case 2 -> assertThat(ours.nextBoolean()).isEqualTo(theirs.nextBoolean());
                default -> assertThat(ours.nextInt()).isEqualTo(theirs.nextInt());
            }
        }
    }

    @Test
    void linearCongruenceGivesTheNumbersOfRandom() {
        for (long seed : SEEDS) {
            assertSameNumbers(new JavaUtilRandom(seed), new Random(seed));
        }
    }

    @Test
    void splitMixGivesTheNumbersOfSplittableRandom() {
        for (long seed : SEEDS) {
            SplittableRandomSource ours = new SplittableRandomSource(seed);
            SplittableRandom theirs = new SplittableRandom(seed);
            for (int i = 0; i < 1000; i++) {
                assertThat(ours.nextLong()).isEqualTo(theirs.nextLong());
                assertThat(ours.nextDouble()).isEqualTo(theirs.nextDouble());
            }
        }
    }

    @Test
    void bothGoOnFromTheirStates() {
        assertGoesOn(new JavaUtilRandom(5), new JavaUtilRandom(6));
        assertGoesOn(new SplittableRandomSource(5), new SplittableRandomSource(6));
    }

    private static <R extends RandomGenerator & Restorable> void assertGoesOn(R first, R second) {
        first.nextDouble();
        StateWriter out = new StateWriter();
        first.save(out);

        second.restore(new StateReader(out.toBytes()));

        assertSameNumbers(second, first);
    }
}
