package org.robonewbie.simulator.physics.sparse;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ScratchCapacityTest {

    private final ScratchCapacity capacity = new ScratchCapacity(100);

    @Test
    void growsAtOnceWithSomethingToSpare() {
        assertThat(capacity.fit(0, 10)).isEqualTo(100);
        assertThat(capacity.fit(100, 1000)).isEqualTo(1500);
    }

    @Test
    void staysWhileALargeIslandComesNowAndThen() {
        for (int i = 1; i <= 200_000; i++) {
            assertThat(capacity.fit(1500, i % 1_500 == 0 ? 1000 : 20)).isEqualTo(1500);
        }
    }

    @Test
    void shrinksWhenLargeIslandsAreGone() {
        int length = 1500;
        for (int i = 0; i < 60_000; i++) {
            length = capacity.fit(length, 20);
        }

        assertThat(length).isEqualTo(100);
    }
}
