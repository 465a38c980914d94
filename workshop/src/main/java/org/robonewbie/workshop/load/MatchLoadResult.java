package org.robonewbie.workshop.load;

import java.util.Locale;

/**
 * Cost of one match under load.
 *
 * @param match number of the match within the run, starting from 1
 * @param cycles number of simulation cycles
 * @param playSeconds game time at the end of the match
 * @param missedCycles cycles by which the simulation fell behind real time
 * @param serverMilliseconds processor time of the server thread per cycle
 * @param processMilliseconds processor time of the whole process per cycle, including all agents
 * @param usualJitterMilliseconds 99th percentile of the jitter: how far the interval between two messages to an agent
 *     deviates from 20 ms
 * @param worstJitterMilliseconds maximum jitter
 * @param heapMegabytes memory in use after a garbage collection, while the robots are waiting for the next kick-off
 */
public record MatchLoadResult(
        int match,
        long cycles,
        double playSeconds,
        long missedCycles,
        double serverMilliseconds,
        double processMilliseconds,
        double usualJitterMilliseconds,
        double worstJitterMilliseconds,
        double heapMegabytes) {

    /** Header of the table, aligned with {@link #toLine}. */
    public static final String TITLE =
            "match  cycles   play s  missed  server ms  process ms  jitter 99 % ms  worst ms  heap MB";

    /**
     * Formats the result as a row of the table.
     *
     * @return one line without a line break
     */
    public String toLine() {
        return String.format(
                Locale.ROOT,
                "%5d %7d %8.1f %7d %10.2f %11.2f %15.2f %9.2f %8.1f",
                match,
                cycles,
                playSeconds,
                missedCycles,
                serverMilliseconds,
                processMilliseconds,
                usualJitterMilliseconds,
                worstJitterMilliseconds,
                heapMegabytes);
    }
}
