package org.robonewbie.workshop.load;

import java.util.Locale;

/**
 * The cost of one match under load.
 *
 * @param match number of the match within the run, from 1
 * @param cycles cycles of the world
 * @param playSeconds game time on the referee's clock in the end
 * @param missedCycles cycles by which the world fell behind real time
 * @param serverMilliseconds processor time of the server's thread for one cycle
 * @param processMilliseconds processor time for one cycle of the whole process, with all agents
 * @param usualJitterMilliseconds maximum deviation from 20 ms of the time between two messages to an agent, in 99 % of all
 *     cycles
 * @param worstJitterMilliseconds the same in all cycles
 * @param heapMegabytes memory in use after a garbage collection, when the robots stand for the next kick-off: always the same
 *     state of the world
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

    /** The table's first line, which fits to {@link #toLine}. */
    public static final String TITLE =
            "match  cycles   play s  missed  server ms  process ms  jitter 99 % ms  worst ms  heap MB";

    /**
     * Adds the memory, which is measured later.
     *
     * @param megabytes memory in use
     * @return this result with that
     */
    MatchLoadResult withHeap(double megabytes) {
        return new MatchLoadResult(
                match,
                cycles,
                playSeconds,
                missedCycles,
                serverMilliseconds,
                processMilliseconds,
                usualJitterMilliseconds,
                worstJitterMilliseconds,
                megabytes);
    }

    /**
     * Writes the result for people.
     *
     * @return one line
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
