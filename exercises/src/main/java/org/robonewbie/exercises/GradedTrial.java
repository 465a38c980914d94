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
import org.robonewbie.trial.Performer;

/** One trial of an exercise with one seed. Another thread may check whether it is still running. */
final class GradedTrial implements Callable<Score> {

    private static final ThreadMXBean CLOCKS = ManagementFactory.getThreadMXBean();
    private static final double NANOSECONDS_PER_SECOND = 1e9;
    private static final Set<Thread.State> WAITING = Set.of(Thread.State.WAITING, Thread.State.TIMED_WAITING);

    private static final String TRIALS = Performer.class.getPackageName() + ".";

    private final Exercise exercise;
    private final Supplier<? extends Agent> student;
    private final long seed;
    private final Optional<Path> recording;
    private final AtomicLong progress = new AtomicLong();
    private volatile long begun;
    private volatile Optional<Thread> thread = Optional.empty();

    GradedTrial(Exercise exercise, Supplier<? extends Agent> student, long seed, Optional<Path> recording) {
        this.exercise = exercise;
        this.student = student;
        this.seed = seed;
        this.recording = recording;
    }

    long seed() {
        return seed;
    }

    /** The number of cycles so far; 0 before the trial begins. */
    long progress() {
        return progress.get();
    }

    /** Where the student's program is at the moment; empty if it is not at work. */
    Optional<String> place() {
        return thread.flatMap(runner -> place(runner.getStackTrace()));
    }

    /** How long a processor has worked on this trial; 0 if none works on it now. */
    double processorSeconds() {
        return thread.map(runner -> (CLOCKS.getThreadCpuTime(runner.getId()) - begun) / NANOSECONDS_PER_SECOND)
                .orElse(0.0);
    }

    /** Whether the student's program sleeps, or waits for something that never happens. */
    boolean isWaiting() {
        return thread.filter(runner -> WAITING.contains(runner.getState()))
                .flatMap(runner -> place(runner.getStackTrace()))
                .isPresent();
    }

    static Optional<String> place(StackTraceElement[] trace) {
        return StudentCode.place(Arrays.stream(trace)
                .takeWhile(frame -> !isFramework(frame.getClassName()))
                .toArray(StackTraceElement[]::new));
    }

    /** Whatever these classes call for a program is the program's own doing; what they do themselves is not. */
    private static boolean isFramework(String className) {
        return className.startsWith(TRIALS) || className.equals(GradedTrial.class.getName());
    }

    @Override
    public Score call() {
        begun = CLOCKS.getCurrentThreadCpuTime();
        thread = Optional.of(Thread.currentThread());
        progress.set(1);
        try {
            return Performance.of(
                    exercise,
                    seed,
                    () -> Performer.ofAgent(student.get()),
                    recording,
                    trial -> progress.incrementAndGet());
        } finally {
            thread = Optional.empty();
        }
    }
}
