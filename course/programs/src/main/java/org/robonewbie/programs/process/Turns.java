package org.robonewbie.programs.process;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Measures how long the simulated world waits for a program. Program and world take turns: while one computes, the other
 * waits. Computation is measured in the program's processor time and sleeping in elapsed time, so the load on the computer
 * does not matter.
 */
final class Turns {

    /**
     * Number of turns begun so far; odd while the world waits for the program. In its first turn, the program requests its
     * robot; in later turns, it sends commands.
     */
    private final AtomicLong count = new AtomicLong(1);

    private long lastCount;
    private double lastProcessorSeconds;
    private double lastSeconds;
    private double waited;
    private double slept;

    /** Ends the current turn and begins the next one. */
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

    /** Returns the duration of the program's current turn in seconds; 0 during the world's turn. */
    synchronized double waitedSeconds() {
        return waited;
    }

    /** Returns the total time in seconds for which the program has slept while the world was waiting for it. */
    synchronized double sleptSeconds() {
        return slept;
    }
}
