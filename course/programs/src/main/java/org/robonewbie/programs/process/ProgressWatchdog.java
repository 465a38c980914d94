package org.robonewbie.programs.process;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Watches from another thread whether a program that works in one thread makes progress. What counts is the processor time that it uses
 * and the time that it sleeps: neither a debugger nor a busy computer makes it late.
 *
 * <pre>{@code
 * watchdog.begin();                        // in the program's thread
 * while (program.runsOneCycle()) {
 *     watchdog.progress();
 * }
 * }</pre>
 */
public final class ProgressWatchdog {

    /** How often {@link #tick} wants to be called, in milliseconds. */
    public static final int TICK_MILLISECONDS = 20;

    private static final ThreadMXBean CLOCKS = ManagementFactory.getThreadMXBean();
    private static final double NANOSECONDS_PER_SECOND = 1e9;
    private static final double TICK_SECONDS = TICK_MILLISECONDS / 1000.0;

    /** How long a step may last, in seconds. */
    public static final int SECONDS = 4;

    private static final Set<Thread.State> WAITING = Set.of(Thread.State.WAITING, Thread.State.TIMED_WAITING);

    private final AtomicLong progress = new AtomicLong();
    private volatile long begun;
    private volatile Optional<Thread> thread = Optional.empty();
    private long progressBefore;
    private double workedBefore;
    private int ticksAsleep;

    /** Begins in the program's thread, which is the present one. */
    public void begin() {
        begun = CLOCKS.getCurrentThreadCpuTime();
        thread = Optional.of(Thread.currentThread());
        progress.set(1);
    }

    /** Notes that the program has done its part of a cycle. */
    public void progress() {
        progress.incrementAndGet();
    }

    /** Ends; from now on there is nothing to wait for. */
    public void end() {
        thread = Optional.empty();
    }

    /** {@return whether the program's thread has begun} */
    public boolean hasBegun() {
        return progress.get() > 0;
    }

    /** Looks, every 20 ms and always in the same thread, what the program does. */
    public void tick() {
        if (progress.get() != progressBefore) {
            progressBefore = progress.get();
            workedBefore = processorSeconds();
            ticksAsleep = 0;
        } else if (progressBefore == 0 || isWaiting()) {
            ticksAsleep++;
        }
    }

    /** {@return whether it has lasted too long} */
    public boolean isExhausted() {
        return processorSeconds() - workedBefore + ticksAsleep * TICK_SECONDS >= SECONDS;
    }

    /** {@return where the program is at the moment; empty if it is not at work} */
    public Optional<String> place() {
        return thread.flatMap(runner -> ProgramPlace.in(runner.getStackTrace()));
    }

    /** How long a processor has worked for the program; 0 if none works for it now. */
    private double processorSeconds() {
        return thread.map(runner -> (CLOCKS.getThreadCpuTime(runner.getId()) - begun) / NANOSECONDS_PER_SECOND)
                .orElse(0.0);
    }

    /** Whether the program sleeps, or waits for something that never happens. */
    private boolean isWaiting() {
        return thread.filter(runner -> WAITING.contains(runner.getState()))
                .flatMap(runner -> ProgramPlace.in(runner.getStackTrace()))
                .isPresent();
    }
}
