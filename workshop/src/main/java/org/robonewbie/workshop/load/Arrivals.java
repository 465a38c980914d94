package org.robonewbie.workshop.load;

import java.util.Arrays;
import org.robonewbie.nao.Cycle;

/** The arrival times of a server's messages at one agent; filled by one thread and read when it has ended or is paused. */
final class Arrivals {

    private static final double NANOSECONDS = 1e9;

    private double[] lateness = new double[1 << 15];
    private int count;
    private long lastNanoseconds;
    private double lastSeconds;

    /**
     * Notes a message.
     *
     * @param nanoseconds when it came
     * @param seconds what time it is in the world
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

    /** Forgets all that came so far. */
    synchronized void restart() {
        count = 0;
        lastSeconds = 0;
    }

    /**
     * Returns the deviation of the time between two messages from 20 ms.
     *
     * @param share fraction of the messages with at most that deviation, 0 to 1
     * @return seconds, at least 0
     */
    synchronized double deviationSeconds(double share) {
        double[] sorted =
                Arrays.stream(lateness, 0, count).map(Math::abs).sorted().toArray();
        return count == 0 ? 0 : sorted[(int) Math.min(count - 1, Math.floor(share * count))];
    }
}
