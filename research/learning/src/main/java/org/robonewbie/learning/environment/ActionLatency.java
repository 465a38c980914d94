package org.robonewbie.learning.environment;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.Random;

/**
 * Latency of a robot's actions: a constant number of cycles, plus a number that is drawn for each cycle. An action never arrives after a
 * later one.
 */
final class ActionLatency {

    @SuppressWarnings("ArrayRecordComponent")
    private record Sent(long arrival, double[] action) {}

    private final int delay;
    private final int jitter;
    private final Random random;
    private final Queue<Sent> waiting = new ArrayDeque<>();
    private double[] current;
    private long cycle;

    /**
     * Creates the latency of an episode.
     *
     * @param delay constant latency in cycles
     * @param jitter largest additional latency in cycles
     * @param first the action until another one arrives
     */
    ActionLatency(int delay, int jitter, Random random, double... first) {
        this.delay = delay;
        this.jitter = jitter;
        this.random = random;
        this.current = first;
    }

    /** Sends an action and returns the one that takes effect in this cycle. Call once per cycle. */
    double[] send(double... action) {
        int more = jitter > 0 ? random.nextInt(jitter + 1) : 0;
        long arrival = cycle + delay + more;
        waiting.removeIf(sent -> sent.arrival > arrival);
        waiting.add(new Sent(arrival, action));
        while (!waiting.isEmpty() && waiting.peek().arrival <= cycle) {
            current = waiting.remove().action;
        }
        cycle++;
        return current;
    }
}
