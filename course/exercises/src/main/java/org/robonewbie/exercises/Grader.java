package org.robonewbie.exercises;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import java.util.stream.LongStream;
import org.robonewbie.agent.Agent;
import org.robonewbie.programs.process.Departure;
import org.robonewbie.programs.process.ProgressWatchdog;

/**
 * Grades solutions of exercises in this process, on the truth of the simulated world, for tests. A program that throws or never
 * returns fails its trial and nothing else, see {@link ProgressWatchdog}. {@code robonewbie grade} judges in the same way a program that runs
 * in another process.
 */
public final class Grader {

    private final int tasksAtOnce;

    /** Creates a grader that tries as many seeds at once as this computer has processors. */
    public Grader() {
        this(Runtime.getRuntime().availableProcessors());
    }

    /**
     * Creates a grader.
     *
     * @param trialsAtOnce how many seeds are tried at once, at least 1
     */
    public Grader(int trialsAtOnce) {
        this.tasksAtOnce = Math.max(1, trialsAtOnce);
    }

    /**
     * Grades a solution on the seeds 1, 2, 3 and so on.
     *
     * @param exercise the exercise
     * @param student makes a robot with the student's program; asked once for each robot
     * @param seeds how many seeds, at least 1
     * @return the grade
     */
    public Grade grade(Exercise exercise, Supplier<? extends Agent> student, int seeds) {
        return grade(exercise, student, LongStream.rangeClosed(1, seeds).boxed().toList(), Optional.empty());
    }

    /**
     * Grades a solution.
     *
     * @param exercise the exercise
     * @param student makes a robot with the student's program; asked once for each robot, from several threads
     * @param seeds the seeds to try
     * @param recording file for a recording of the first seed, for the studio; empty for none
     * @return the grade
     */
    public Grade grade(
            Exercise exercise, Supplier<? extends Agent> student, List<Long> seeds, Optional<Path> recording) {
        ExecutorService threads = Executors.newFixedThreadPool(tasksAtOnce, Grader::daemon);
        List<GradedTrial> trials = new ArrayList<>();
        List<Future<Score>> scores = new ArrayList<>();
        for (long seed : seeds) {
            GradedTrial trial = new GradedTrial(
                    exercise, student, seed, scores.isEmpty() ? recording : Optional.empty(), new ProgressWatchdog());
            trials.add(trial);
            scores.add(threads.submit(trial));
        }
        List<Grade.SeededScore> results = new ArrayList<>();
        for (int i = 0; i < trials.size(); i++) {
            results.add(new Grade.SeededScore(trials.get(i).seed(), await(trials.get(i), scores.get(i))));
        }
        threads.shutdownNow();
        return new Grade(exercise.fullName(), results);
    }

    /** Waits for a score as long as the trial makes progress. */
    private static Score await(GradedTrial trial, Future<Score> score) {
        while (!trial.progress().isExhausted()) {
            try {
                return score.get(ProgressWatchdog.TICK_MILLISECONDS, TimeUnit.MILLISECONDS);
            } catch (TimeoutException notYet) {
                trial.progress().tick();
            } catch (ExecutionException exhausted) {
                return Score.failed(
                        0, "The program ended with " + exhausted.getCause() + ".", "Does it keep too much?");
            } catch (InterruptedException end) {
                Thread.currentThread().interrupt();
                return Score.failed(0, "The grading was stopped.", "");
            }
        }
        return trial.progress().hasBegun()
                ? Performance.of(
                        Score.notTried(),
                        new Departure(
                                Departure.Cause.ENDLESS,
                                trial.progress().place().orElse(""),
                                ""))
                : Score.notTried();
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(work, "trial");
        thread.setDaemon(true);
        return thread;
    }
}
