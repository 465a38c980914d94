package org.robonewbie.learning.environment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ActionLatencyTest {

    @Test
    void actionsArriveAfterTheDelay() {
        ActionLatency latency = new ActionLatency(2, 0, new Random(1), -1);

        assertThat(arrivals(latency, 5)).containsExactly(-1, -1, 0, 1, 2);
    }

    @Test
    void jitterDelaysActionsWithoutChangingTheirOrder() {
        ActionLatency latency = new ActionLatency(1, 3, new Random(1), -1);

        List<Integer> arrived = arrivals(latency, 200);

        assertThat(arrived).isSorted();
        List<Integer> late = IntStream.range(10, 200)
                .mapToObj(cycle -> cycle - arrived.get(cycle))
                .toList();
        assertThat(late).allMatch(cycles -> cycles >= 1 && cycles <= 4).contains(1, 2, 3);
    }

    /** Sends the number of the cycle and returns the number that takes effect in each cycle. */
    private static List<Integer> arrivals(ActionLatency latency, int cycles) {
        return IntStream.range(0, cycles)
                .mapToObj(cycle -> (int) latency.send(cycle)[0])
                .toList();
    }
}
