package org.robonewbie.exercises;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.log.StudentCode;

/** One trial of an exercise with one seed. Another thread may look whether it still goes on. */
final class Trial implements Callable<Score> {

    private static final ThreadMXBean CLOCKS = ManagementFactory.getThreadMXBean();
    private static final double NANOSECONDS_PER_SECOND = 1e9;
    private static final Set<Thread.State> WAITING = Set.of(Thread.State.WAITING, Thread.State.TIMED_WAITING);

    /** Whatever these call for a program is the program's own doing; what they do themselves is not. */
    private static final Set<String> STAGE = Set.of(
            Stage.class.getName(),
            Player.class.getName(),
            AgentProgram.class.getName(),
            Performance.class.getName(),
            Trial.class.getName());

    private final Exercise exercise;
    private final Supplier<? extends Agent> student;
    private final long seed;
    private final Optional<Path> recording;
    private final AtomicLong progress = new AtomicLong();
    private volatile long begun;
    private volatile Optional<Thread> thread = Optional.empty();

    Trial(Exercise exercise, Supplier<? extends Agent> student, long seed, Optional<Path> recording) {
        this.exercise = exercise;
        this.student = student;
        this.seed = seed;
        this.recording = recording;
    }

    long seed() {
        return seed;
    }

    /** Counts what has been done so far; 0 before the trial begins. */
    long progress() {
        return progress.get();
    }

    /** Where the student's program is at the moment; empty if it is not at work. */
    Optional<String> place() {
        return thread.flatMap(runner -> place(runner.getStackTrace()));
    }

    /** How long a processor has worked on this trial; 0 if nobody works on it now. */
    double processorSeconds() {
        return thread.map(runner -> (CLOCKS.getThreadCpuTime(runner.getId()) - begun) / NANOSECONDS_PER_SECOND)
                .orElse(0.0);
    }

    /** Whether the student's program sleeps, or waits for something that nobody does. */
    boolean isWaiting() {
        return thread.filter(runner -> WAITING.contains(runner.getState()))
                .flatMap(runner -> place(runner.getStackTrace()))
                .isPresent();
    }

    static Optional<String> place(StackTraceElement[] trace) {
        return StudentCode.place(Arrays.stream(trace)
                .takeWhile(frame -> !STAGE.contains(frame.getClassName()))
                .toArray(StackTraceElement[]::new));
    }

    @Override
    public Score call() {
        begun = CLOCKS.getCurrentThreadCpuTime();
        thread = Optional.of(Thread.currentThread());
        progress.set(1);
        try {
            return Performance.of(
                    exercise, seed, () -> Program.of(student.get()), recording, stage -> progress.incrementAndGet());
        } finally {
            thread = Optional.empty();
        }
    }
}
