package org.robonewbie.exercises.grading;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.stream.LongStream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Grader;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.programs.process.Departure;
import org.robonewbie.programs.process.RobotProcess;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.trial.TrialListener;
import org.robonewbie.trial.batch.BatchRunner;

/**
 * Grades programs that run in a child process. The simulated world and the scoring run in this process; the program can
 * influence them only through its robots. A program that exits, exhausts its memory or never returns fails its trial
 * and affects no other program.
 *
 * @param seeds the number of trials, which use the seeds 1, 2, 3 and so on
 * @param threads the number of trials to run in parallel, at least 1
 * @param sandbox the sandbox of the program
 * @param recording file for a recording of the first trial; empty for none
 * @param output receives each line printed by the program
 */
public record ProcessGrader(
        int seeds, int threads, Sandbox sandbox, Optional<Path> recording, Consumer<String> output) {

    private static final int START_SECONDS = 60;
    private static final int SECONDS_PER_TRIAL = 20;

    /**
     * Result of grading a program.
     *
     * @param grade the grade; empty if the program could not be started
     * @param exitCode exit code of a program that could not be started; otherwise 0
     * @param output first lines of the output
     */
    public record Result(Optional<Grade> grade, int exitCode, List<String> output) {}

    /**
     * Grades a program.
     *
     * @param exercise the exercise
     * @param program the program
     * @param scores receives each score as soon as it is available
     * @return the result
     * @throws IOException if the process cannot be started
     */
    public Result grade(Exercise exercise, RobotProcess.Request program, BatchRunner.Receiver<Long, Score> scores)
            throws IOException {
        AtomicBoolean late = new AtomicBoolean();
        CompletableFuture<Void> end = new CompletableFuture<>();
        try (RobotProcess student = new RobotProcess(program, sandbox, output)) {
            CompletableFuture<Void> deadline = deadline(end, student, late);
            Grade grade = new Grader(threads)
                    .grade(
                            exercise,
                            LongStream.rangeClosed(1, seeds).boxed().toList(),
                            seed -> trial(exercise, seed, student, late),
                            scores);
            end.complete(null);
            deadline.join();
            return student.isReady()
                    ? new Result(Optional.of(grade), 0, student.lines())
                    : new Result(Optional.empty(), student.exitCode(), student.lines());
        }
    }

    /** Kills the program if it does not finish in time. */
    private CompletableFuture<Void> deadline(CompletableFuture<Void> end, RobotProcess student, AtomicBoolean late) {
        return end.orTimeout(START_SECONDS + (long) SECONDS_PER_TRIAL * seeds, TimeUnit.SECONDS)
                .exceptionally(timeout -> {
                    late.set(true);
                    student.close();
                    return null;
                });
    }

    private Score trial(Exercise exercise, long seed, RobotProcess student, AtomicBoolean late) throws IOException {
        Optional<Path> file = recording.filter(wanted -> seed == 1);
        Score score = trial(exercise, seed, student, file, TrialListener.NONE);
        return late.get()
                ? Score.failed(
                        0,
                        "The program took too long.",
                        student.slowness()
                                .map(Departure::text)
                                .orElse("Is it waiting for something that never happens?"))
                : score;
    }

    /**
     * Runs one trial.
     *
     * @param exercise the exercise
     * @param seed seed of the trial
     * @param student the program
     * @param recording file for a recording; empty for none
     * @param listener observes the trial
     * @return the score; if robots have left early, its finding explains why
     * @throws IOException if no port is free
     */
    public static Score trial(
            Exercise exercise, long seed, RobotProcess student, Optional<Path> recording, TrialListener listener)
            throws IOException {
        try (RobotProcess.Entrance entrance = student.entrance()) {
            Score score = Performance.of(exercise, seed, entrance, recording, listener);
            return score.passed()
                    ? score
                    : entrance.departure()
                            .map(why -> Performance.of(score, why))
                            .orElse(score);
        }
    }
}
