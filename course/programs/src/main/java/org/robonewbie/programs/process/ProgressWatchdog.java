package org.robonewbie.programs.process;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Watchdog that detects when a program in another thread makes no progress. Time counts only while the program computes or
 * sleeps, so neither a debugger nor a busy computer triggers the watchdog.
 *
 * <pre>{@code
 * watchdog.begin();                        // in the program's thread
 * while (program.runsOneCycle()) {
 *     watchdog.progress();
 * }
 * }</pre>
 */
public final class ProgressWatchdog {

    /** Interval between calls to {@link #tick} in milliseconds. */
    public static final int TICK_MILLISECONDS = 20;

    private static final ThreadMXBean CLOCKS = ManagementFactory.getThreadMXBean();
    private static final double NANOSECONDS_PER_SECOND = 1e9;
    private static final double TICK_SECONDS = TICK_MILLISECONDS / 1000.0;

    /** Maximum duration of a step in seconds. */
    public static final int SECONDS = 4;

    private static final Set<Thread.State> WAITING = Set.of(Thread.State.WAITING, Thread.State.TIMED_WAITING);

    private final AtomicLong progress = new AtomicLong();
    private volatile long begun;
    private volatile Optional<Thread> thread = Optional.empty();
    private long progressBefore;
    private double workedBefore;
    private int ticksAsleep;

    /** Starts the watchdog for the current thread. */
    public void begin() {
        begun = CLOCKS.getCurrentThreadCpuTime();
        thread = Optional.of(Thread.currentThread());
        progress.set(1);
    }

    /** Records that the program has completed a step. */
    public void progress() {
        progress.incrementAndGet();
    }

    /** Stops the watchdog. */
    public void end() {
        thread = Optional.empty();
    }

    /** Samples the state of the program. Call this every 20 ms, always from the same thread. */
    public void tick() {
        if (progress.get() != progressBefore) {
            progressBefore = progress.get();
            workedBefore = processorSeconds();
            ticksAsleep = 0;
        } else if (progressBefore == 0 || isWaiting()) {
            ticksAsleep++;
        }
    }

    /** {@return whether the current step has taken too long} */
    public boolean isExhausted() {
        return processorSeconds() - workedBefore + ticksAsleep * TICK_SECONDS >= SECONDS;
    }

    /** {@return the current line of the program; empty if its code is not active} */
    public Optional<String> place() {
        return thread.flatMap(runner -> ProgramPlace.in(runner.getStackTrace()));
    }

    /** Returns the processor time since {@link #begin}; 0 after {@link #end}. */
    private double processorSeconds() {
        return thread.map(runner -> (CLOCKS.getThreadCpuTime(runner.getId()) - begun) / NANOSECONDS_PER_SECOND)
                .orElse(0.0);
    }

    /** Returns whether the program's own code is sleeping or waiting. */
    private boolean isWaiting() {
        return thread.filter(runner -> WAITING.contains(runner.getState()))
                .flatMap(runner -> ProgramPlace.in(runner.getStackTrace()))
                .isPresent();
    }
}
