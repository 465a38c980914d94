package org.robonewbie.simulator.physics.sparse;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RoomTest {

    private final Room room = new Room(100);

    @Test
    void growsAtOnceWithSomethingToSpare() {
        assertThat(room.fit(0, 10)).isEqualTo(100);
        assertThat(room.fit(100, 1000)).isEqualTo(1500);
    }

    @Test
    void staysWhileALargeIslandComesNowAndThen() {
        for (int i = 1; i <= 200_000; i++) {
            assertThat(room.fit(1500, i % 1_500 == 0 ? 1000 : 20)).isEqualTo(1500);
        }
    }

    @Test
    void shrinksWhenLargeIslandsAreGone() {
        int length = 1500;
        for (int i = 0; i < 60_000; i++) {
            length = room.fit(length, 20);
        }

        assertThat(length).isEqualTo(100);
    }
}
