package org.robonewbie.simulator.load;

import java.util.Locale;

/**
 * What one match under load has cost.
 *
 * @param match number of the match within the run, from 1
 * @param cycles cycles of the world
 * @param playSeconds time of play that the referee's clock shows in the end
 * @param missedCycles cycles that real time had and the world had not
 * @param serverMilliseconds processor time of the server's thread for one cycle
 * @param processMilliseconds processor time for one cycle of the whole process, with all agents
 * @param usualJitterMilliseconds how far the time between two messages to an agent is from 20 ms at most, in 99 % of all
 *     cycles
 * @param worstJitterMilliseconds the same in all cycles
 * @param heapMegabytes memory that is in use, after a collection of garbage, when the robots stand for the next kick-off: always
 *     the same state of the world
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
