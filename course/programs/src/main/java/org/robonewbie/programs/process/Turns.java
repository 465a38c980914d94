package org.robonewbie.programs.process;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Counts the alternating turns of program and world, and measures how long the world waits for the program. Computation is
 * measured in the program's processor time and sleeping in elapsed time, so the load on the computer does not matter.
 */
final class Turns {

    /**
     * Number of turns so far, which is odd during the program's turn. In its first turn, the program requests its
     * robot; in later ones, it sends commands.
     */
    private final AtomicLong count = new AtomicLong(1);

    private long lastCount;
    private double lastProcessorSeconds;
    private double lastSeconds;
    private double waited;
    private double slept;

    /** Passes the turn. */
    void next() {
        count.incrementAndGet();
    }

    /** Returns whether the program has requested its robot. */
    boolean hasBegun() {
        return count.get() > 1;
    }

    /**
     * Adds a sample to the measurement. Call this at regular intervals.
     *
     * @param seconds elapsed time
     * @param processorSeconds processor time of the program
     * @param atWork whether the program is runnable
     */
    synchronized void look(double seconds, double processorSeconds, boolean atWork) {
        long now = count.get();
        boolean same = now == lastCount && now % 2 == 1;
        double calculated = processorSeconds - lastProcessorSeconds;
        double asleep = same && !atWork && calculated == 0 ? seconds - lastSeconds : 0;
        slept += asleep;
        waited = same ? waited + asleep + calculated : 0;
        lastCount = now;
        lastSeconds = seconds;
        lastProcessorSeconds = processorSeconds;
    }

    /** Returns the duration of the current turn of the program. */
    synchronized double waitedSeconds() {
        return waited;
    }

    /** Returns the total time that the program has slept in its turns. */
    synchronized double sleptSeconds() {
        return slept;
    }
}
