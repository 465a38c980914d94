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

/**
 * Grades solutions of exercises in this process, on the truth of the simulated world. The same grader works behind {@code
 * robonewbie grade} and in tests.
 *
 * <p>A program that throws or never returns fails its trial and nothing else. What counts against a
 * program is the time of the processor that it uses and the time that it sleeps: neither a debugger nor a busy computer makes it
 * late.
 */
public final class Grader {

    private static final int TICK_MILLISECONDS = 20;
    private static final double TICK_SECONDS = TICK_MILLISECONDS / 1000.0;
    private static final double SECONDS_OF_PATIENCE = 4;

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
            GradedTrial trial =
                    new GradedTrial(exercise, student, seed, scores.isEmpty() ? recording : Optional.empty());
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
        long progress = 0;
        double workedBefore = 0;
        int ticksAsleep = 0;
        while (trial.processorSeconds() - workedBefore + ticksAsleep * TICK_SECONDS < SECONDS_OF_PATIENCE) {
            try {
                return score.get(TICK_MILLISECONDS, TimeUnit.MILLISECONDS);
            } catch (TimeoutException notYet) {
                if (trial.progress() != progress) {
                    progress = trial.progress();
                    workedBefore = trial.processorSeconds();
                    ticksAsleep = 0;
                } else if (progress == 0 || trial.isWaiting()) {
                    ticksAsleep++;
                }
            } catch (ExecutionException exhausted) {
                return Score.failed(
                        0, "The program ended with " + exhausted.getCause() + ".", "Does it keep too much?");
            } catch (InterruptedException end) {
                Thread.currentThread().interrupt();
                return Score.failed(0, "The grading was stopped.", "");
            }
        }
        return stuck(trial);
    }

    private static Score stuck(GradedTrial trial) {
        if (trial.progress() == 0) {
            return Score.failed(0, "Not tried, since the trials before did not end.", "");
        }
        String place = trial.place().map(line -> "; it is in " + line).orElse("");
        return Score.failed(
                0,
                "think() has not returned for " + Math.round(SECONDS_OF_PATIENCE) + " s" + place + ".",
                "think() is called 50 times per second and must return at once. Is there an endless loop?");
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(work, "trial");
        thread.setDaemon(true);
        return thread;
    }
}
