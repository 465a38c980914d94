package org.robonewbie.workshop.load;

import java.util.Arrays;
import org.robonewbie.nao.Cycle;

/**
 * Arrival times of the messages at one agent. Written by one thread, and read by another only after the writer has
 * finished or paused.
 */
final class Arrivals {

    private static final double NANOSECONDS = 1e9;

    private double[] lateness = new double[1 << 15];
    private int count;
    private long lastNanoseconds;
    private double lastSeconds;

    /**
     * Records a message.
     *
     * @param nanoseconds arrival time
     * @param seconds simulation time
     */
    synchronized void add(long nanoseconds, double seconds) {
        if (lastSeconds > 0 && seconds - lastSeconds < 1.5 * Cycle.SECONDS) {
            if (count == lateness.length) {
                lateness = Arrays.copyOf(lateness, 2 * count);
            }
            lateness[count++] = (nanoseconds - lastNanoseconds) / NANOSECONDS - Cycle.SECONDS;
        }
        lastNanoseconds = nanoseconds;
        lastSeconds = seconds;
    }

    /** Discards all recorded messages. */
    synchronized void restart() {
        count = 0;
        lastSeconds = 0;
    }

    /**
     * Returns a quantile of the jitter: how far the intervals between consecutive messages deviate from 20 ms.
     *
     * @param share the quantile, 0 to 1
     * @return seconds, at least 0
     */
    synchronized double deviationSeconds(double share) {
        double[] sorted =
                Arrays.stream(lateness, 0, count).map(Math::abs).sorted().toArray();
        return count == 0 ? 0 : sorted[(int) Math.min(count - 1, Math.floor(share * count))];
    }
}
