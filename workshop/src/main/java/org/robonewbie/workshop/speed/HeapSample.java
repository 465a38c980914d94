package org.robonewbie.workshop.speed;

import java.lang.management.ManagementFactory;
import java.util.Locale;

/**
 * The memory in use at one moment of a long run.
 *
 * @param seconds simulated time since the beginning of the measurement
 * @param bytes heap size after a garbage collection, agents and everything else in the process included
 */
public record HeapSample(double seconds, long bytes) {

    /** Collects garbage and takes a sample. */
    static HeapSample at(double seconds) {
        ManagementFactory.getMemoryMXBean().gc();
        return new HeapSample(
                seconds,
                ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed());
    }

    /**
     * Writes the sample for people.
     *
     * @return one line
     */
    public String toLine() {
        return String.format(Locale.ROOT, "  after %.0f s: %.2f MB%n", seconds, bytes / 1e6);
    }
}
