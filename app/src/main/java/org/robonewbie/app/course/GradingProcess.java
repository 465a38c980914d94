package org.robonewbie.app.course;

import java.io.IOException;
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
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.programs.process.Departure;
import org.robonewbie.programs.process.RobotProcess;
import org.robonewbie.trial.TrialListener;

/**
 * Grades a program that runs in a separate process. World and judge are in this one: the program speaks with them as an agent with a
 * simulator and can tell them nothing but what its robots do. A program that ends its process, takes all memory or never returns costs
 * its author the trial and others nothing.
 */
public final class GradingProcess {

    private static final int SECONDS_AT_LEAST = 60;
    private static final int SECONDS_FOR_EACH_SEED = 20;

    private final Exercise exercise;
    private final RobotProcess.Request program;
    private final GradingConditions conditions;
    private volatile boolean stuck;
    private int exitCode;

    /**
     * Prepares the grading of one program.
     *
     * @param exercise what it is to solve
     * @param program the program
     * @param conditions how it is graded
     */
    public GradingProcess(Exercise exercise, RobotProcess.Request program, GradingConditions conditions) {
        this.exercise = exercise;
        this.program = program;
        this.conditions = conditions;
    }

    /**
     * Grades, and waits for the end.
     *
     * @return the grade; none if the program cannot even begin, and why not has been shown
     * @throws IOException if the process cannot be started
     */
    public Optional<Grade> run() throws IOException {
        try (RobotProcess student = RobotProcess.start(program, conditions.sandbox(), conditions.output())) {
            List<Grade.SeededScore> scores = judge(student);
            exitCode = student.isReady() ? 0 : student.exitCode();
            return student.isReady() ? Optional.of(new Grade(exercise.fullName(), scores)) : Optional.empty();
        }
    }

    /** {@return how the process ended that could not begin} */
    public int exitCode() {
        return exitCode;
    }

    private List<Grade.SeededScore> judge(RobotProcess student) {
        ExecutorService threads = Executors.newFixedThreadPool(
                Math.min(conditions.seeds(), conditions.trialsAtOnce()), GradingProcess::daemon);
        List<Future<Score>> trials = new ArrayList<>();
        for (int seed = 1; seed <= conditions.seeds(); seed++) {
            long own = seed;
            trials.add(threads.submit(() -> trial(student, own)));
        }
        List<Grade.SeededScore> scores = new ArrayList<>();
        long end = System.nanoTime()
                + TimeUnit.SECONDS.toNanos(SECONDS_AT_LEAST + (long) SECONDS_FOR_EACH_SEED * conditions.seeds());
        for (Future<Score> trial : trials) {
            scores.add(new Grade.SeededScore(scores.size() + 1, await(trial, end, student)));
        }
        threads.shutdownNow();
        return scores;
    }

    private static Score await(Future<Score> trial, long end, RobotProcess student) {
        try {
            return trial.get(Math.max(0, end - System.nanoTime()), TimeUnit.NANOSECONDS);
        } catch (TimeoutException late) {
            return Score.failed(
                    0,
                    "The program took too long.",
                    student.slowness().map(Departure::text).orElse("Does it wait for something that never comes?"));
        } catch (ExecutionException mistake) {
            throw new IllegalStateException("The judge has failed; please report this.", mistake);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return Score.failed(0, "The grading was stopped.", "");
        }
    }

    private Score trial(RobotProcess student, long seed) throws IOException {
        if (stuck) {
            return Score.notTried();
        }
        Optional<Path> recording = seed == 1 ? conditions.recording() : Optional.empty();
        Score score = trial(exercise, seed, student, recording, TrialListener.NONE);
        stuck |= score.finding().startsWith(Performance.ENDLESS);
        return score;
    }

    /**
     * Plays one trial.
     *
     * @param exercise the exercise
     * @param seed start of all that is left to chance
     * @param student the program
     * @param recording file for a recording; empty for none
     * @param audience watches the trial
     * @return the score, with the reason for which robots have gone before the end
     * @throws IOException if no port is free
     */
    public static Score trial(
            Exercise exercise, long seed, RobotProcess student, Optional<Path> recording, TrialListener audience)
            throws IOException {
        try (RobotProcess.Entrance entrance = student.entrance()) {
            Score score = Performance.of(exercise, seed, entrance, recording, audience);
            return score.passed()
                    ? score
                    : entrance.departure()
                            .map(why -> Performance.of(score, why))
                            .orElse(score);
        }
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(work, "trial");
        thread.setDaemon(true);
        return thread;
    }
}
