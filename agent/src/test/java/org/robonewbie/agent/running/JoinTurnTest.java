package org.robonewbie.agent.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

class JoinTurnTest {

    @Test
    void isOverWhenTheRobotIsAtItsPlace() {
        JoinTurn turn = new JoinTurn(Duration.ofDays(1));
        CompletableFuture<Boolean> next = CompletableFuture.supplyAsync(() -> await(turn));

        turn.answered();
        boolean early = next.isDone();
        turn.end();

        assertThat(early).isFalse();
        assertThat(next.join()).isTrue();
    }

    @Test
    void isNotAwaitedAtAServerThatWaitsForMoreRobots() {
        assertThat(await(new JoinTurn(Duration.ZERO))).isFalse();
    }

    @Test
    void isOverForARobotThatNeverJoins() {
        JoinTurn turn = new JoinTurn(Duration.ofDays(1));

        turn.end();

        assertThat(await(turn)).isTrue();
    }

    private static boolean await(JoinTurn turn) {
        try {
            return turn.await();
        } catch (InterruptedException end) {
            throw new AssertionError(end);
        }
    }
}
