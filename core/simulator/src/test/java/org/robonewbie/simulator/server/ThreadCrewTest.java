package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ThreadCrewTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void eachPieceIsDoneOnceAndSeenByTheOneThatAsked(int threads) {
        int[] done = new int[100];
        try (ThreadCrew crew = new ThreadCrew(threads)) {
            for (int round = 0; round < 1000; round++) {
                crew.divide(round % done.length, piece -> done[piece]++);
            }
        }

        for (int piece = 0; piece < done.length; piece++) {
            assertThat(done[piece]).isEqualTo(10 * (done.length - 1 - piece));
        }
    }

    @Test
    void helpersTakePiecesWhileTheOneThatAskedIsBusy() {
        CountDownLatch both = new CountDownLatch(2);
        AtomicIntegerArray done = new AtomicIntegerArray(2);
        try (ThreadCrew crew = new ThreadCrew(2)) {
            crew.divide(2, piece -> {
                both.countDown();
                awaitQuietly(both);
                done.incrementAndGet(piece);
            });
        }

        assertThat(done.get(0) + done.get(1)).isEqualTo(2);
    }

    private static void awaitQuietly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void whatGoesWrongReachesTheOneThatAskedAndTheCrewGoesOn() {
        try (ThreadCrew crew = new ThreadCrew(2)) {
            assertThatThrownBy(() -> crew.divide(3, piece -> {
                        throw new IllegalArgumentException("piece");
                    }))
                    .isInstanceOf(IllegalArgumentException.class);

            int[] done = new int[3];
            crew.divide(3, piece -> done[piece]++);
            assertThat(done).containsExactly(1, 1, 1);
        }
    }
}
