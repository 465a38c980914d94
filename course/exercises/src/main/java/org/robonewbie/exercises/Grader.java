package org.robonewbie.exercises;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import java.util.stream.LongStream;
import org.robonewbie.agent.Agent;
import org.robonewbie.programs.process.Departure;
import org.robonewbie.programs.process.ProgressWatchdog;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.Job;
import org.robonewbie.trial.batch.ThreadRunner;

/**
 * Grades solutions in this process, using the ground truth of the simulated world. Intended for tests. A program that
 * throws an exception or never returns fails its trial; see {@link ProgressWatchdog}. {@code robonewbie grade} grades in
 * the same way, but runs the program in a child process.
 */
public final class Grader {

    private final int threads;

    /** Creates a grader with a thread for each processor. */
    public Grader() {
        this(Runtime.getRuntime().availableProcessors());
    }

    /**
     * Creates a grader.
     *
     * @param threads the number of trials to run in parallel, at least 1
     */
    public Grader(int threads) {
        this.threads = threads;
    }

    /**
     * Grades a solution for the seeds 1, 2, 3 and so on.
     *
     * @param exercise the exercise
     * @param student creates an agent that runs the student's program; called once for each robot
     * @param seeds the number of seeds, at least 1
     * @return the grade
     */
    public Grade grade(Exercise exercise, Supplier<? extends Agent> student, int seeds) {
        return grade(exercise, student, LongStream.rangeClosed(1, seeds).boxed().toList(), Optional.empty());
    }

    /**
     * Grades a solution.
     *
     * @param exercise the exercise
     * @param student creates an agent that runs the student's program; called once for each robot, from several threads
     * @param seeds the seeds
     * @param recording file for a recording of the trial with the first seed, to be opened in the studio; empty for none
     * @return the grade
     */
    public Grade grade(
            Exercise exercise, Supplier<? extends Agent> student, List<Long> seeds, Optional<Path> recording) {
        return grade(
                exercise,
                seeds,
                seed -> watchedTrial(exercise, student, seed, recording.filter(file -> seed.equals(seeds.get(0)))),
                (seed, score) -> {});
    }

    /**
     * Grades a solution. If a step never returns, the remaining trials are skipped.
     *
     * @param exercise the exercise
     * @param seeds the seeds
     * @param trial runs the trial with a given seed
     * @param scores receives each score as soon as it is available
     * @return the grade
     */
    public Grade grade(
            Exercise exercise, List<Long> seeds, Job<Long, Score> trial, BatchRunner.Receiver<Long, Score> scores) {
        AtomicBoolean endless = new AtomicBoolean();
        List<Score> results;
        try (BatchRunner runner = new ThreadRunner(threads)) {
            Job<Long, Score> job = seed -> {
                Score score = endless.get() ? Score.notTried() : trial.run(seed);
                if (score.finding().startsWith(Performance.ENDLESS)) {
                    endless.set(true);
                }
                return score;
            };
            results = runner.run(seeds, job, scores);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
        List<Grade.SeededScore> trials = new ArrayList<>();
        for (int i = 0; i < results.size(); i++) {
            trials.add(new Grade.SeededScore(seeds.get(i), results.get(i)));
        }
        return new Grade(exercise.fullName(), trials);
    }

    /** Runs a trial in another thread, which is abandoned if the program makes no progress. */
    private static Score watchedTrial(
            Exercise exercise, Supplier<? extends Agent> student, long seed, Optional<Path> recording) {
        ProgressWatchdog watchdog = new ProgressWatchdog();
        FutureTask<Score> trial = new FutureTask<>(() -> {
            watchdog.begin();
            try {
                return Performance.of(
                        exercise,
                        seed,
                        () -> Controller.ofAgent(student.get()),
                        recording,
                        cycle -> watchdog.progress());
            } finally {
                watchdog.end();
            }
        });
        Thread thread = new Thread(trial, "trial");
        thread.setDaemon(true);
        thread.start();
        while (!watchdog.isExhausted()) {
            try {
                return trial.get(ProgressWatchdog.TICK_MILLISECONDS, TimeUnit.MILLISECONDS);
            } catch (TimeoutException running) {
                watchdog.tick();
            } catch (ExecutionException exhausted) {
                return Score.failed(
                        0, "The program ended with " + exhausted.getCause() + ".", "Does it keep too much in memory?");
            } catch (InterruptedException stopped) {
                Thread.currentThread().interrupt();
                return Score.failed(0, "Grading was stopped.", "");
            }
        }
        return Performance.of(
                Score.notTried(),
                new Departure(Departure.Cause.ENDLESS, watchdog.place().orElse(""), ""));
    }
}
