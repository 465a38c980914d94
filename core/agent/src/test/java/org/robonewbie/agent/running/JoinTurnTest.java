package org.robonewbie.agent.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

class JoinTurnTest {

    @Test
    void isOverWhenTheRobotIsAtItsPlace() {
        JoinTurn turn = new JoinTurn(Duration.ofDays(1));
        CompletableFuture<Boolean> next = CompletableFuture.supplyAsync(turn::await);

        turn.answered();
        boolean early = next.isDone();
        turn.end();

        assertThat(early).isFalse();
        assertThat(next.join()).isTrue();
    }

    @Test
    void isNotAwaitedAtAServerThatWaitsForMoreRobots() {
        assertThat(new JoinTurn(Duration.ZERO).await()).isFalse();
    }

    @Test
    void isOverForARobotThatNeverJoins() {
        JoinTurn turn = new JoinTurn(Duration.ofDays(1));

        turn.end();

        assertThat(turn.await()).isTrue();
    }
}
