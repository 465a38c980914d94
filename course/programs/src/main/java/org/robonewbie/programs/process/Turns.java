package org.robonewbie.programs.process;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Whose turn it is, the program's or the world's, and how long a program has been keeping the world waiting. What a program
 * calculates counts by its own processor time, what it sleeps by the clock; so nobody is silent because the computer is busy
 * with others.
 */
final class Turns {

    /** Odd while it is the program's turn; at first to ask for its robot, later to answer. */
    private final AtomicLong count = new AtomicLong(1);

    private long lastCount;
    private double lastProcessorSeconds;
    private double lastSeconds;
    private double waited;
    private double slept;

    /** Passes the turn on. */
    void next() {
        count.incrementAndGet();
    }

    /** Whether the program has asked for its robot. */
    boolean hasBegun() {
        return count.get() > 1;
    }

    /**
     * Looks again.
     *
     * @param seconds the clock
     * @param processorSeconds what the program has calculated so far
     * @param atWork whether it is known to be calculating, or that it would if a processor were free
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

    /** How long the world has been waiting for the program's answer. */
    synchronized double waitedSeconds() {
        return waited;
    }

    /** How long the program has slept on its turns in all. */
    synchronized double sleptSeconds() {
        return slept;
    }
}
