package org.robonewbie.programs.process;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Turn counter of program and world, which measures how long the world waits for the program. Computation counts by the processor time
 * of the program and sleeping by elapsed time, so the load of the computer does not matter.
 */
final class Turns {

    /** Odd during the program's turn: first to request its robot, later to answer. */
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
     * Takes a sample.
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
