package org.robonewbie.exercises;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.log.StudentCode;

/** One trial of an exercise with one seed. Another thread may look whether it still goes on. */
final class Trial implements Callable<Score> {

    private final Exercise exercise;
    private final Supplier<? extends Agent> student;
    private final long seed;
    private final Optional<Path> recording;
    private final AtomicLong progress = new AtomicLong();
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
        return thread.flatMap(runner -> StudentCode.place(runner.getStackTrace()));
    }

    @Override
    public Score call() {
        thread = Optional.of(Thread.currentThread());
        progress.set(1);
        try (Stage stage = new Stage(seed, recording)) {
            Task task = exercise.task().get();
            task.begin(stage, student);
            while (stage.seconds() < exercise.seconds() && !task.isDecided()) {
                stage.cycle();
                progress.incrementAndGet();
                task.watch(stage);
            }
            return task.score();
        } catch (VirtualMachineError exhausted) {
            throw exhausted;
        } catch (Throwable mistake) {
            return broken(mistake);
        } finally {
            thread = Optional.empty();
        }
    }

    private static Score broken(Throwable mistake) {
        String place = StudentCode.place(mistake.getStackTrace())
                .map(line -> " in " + line)
                .orElse("");
        return Score.failed(
                0, "The program ended with " + mistake + place + ".", "Mend this first; the rest was not tried.");
    }
}
