package org.robonewbie.workshop.speed;

import java.lang.management.ManagementFactory;
import java.util.Locale;

/**
 * Memory in use at one point in a long run.
 *
 * @param seconds simulated time since the start of the measurement
 * @param bytes heap size after a garbage collection, for the whole process including the agents
 */
public record HeapSample(double seconds, long bytes) {

    /** Runs a garbage collection and takes a sample. */
    static HeapSample at(double seconds) {
        ManagementFactory.getMemoryMXBean().gc();
        return new HeapSample(
                seconds,
                ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed());
    }

    /**
     * Formats the sample for the console.
     *
     * @return one line with its line break
     */
    public String toLine() {
        return String.format(Locale.ROOT, "  after %.0f s: %.2f MB%n", seconds, bytes / 1e6);
    }
}
