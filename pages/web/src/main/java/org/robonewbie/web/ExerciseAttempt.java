package org.robonewbie.web;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Grade.SeededScore;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.service.CourseHost;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.studio.PageFeed;

/** Attempt at an exercise; the program runs in the page's interpreter. */
final class ExerciseAttempt implements CourseHost.Attempt {

    private static final int MAX_CHARACTERS = 20_000;
    private static final long SEED_OF_EMPTY_PITCH = 1;

    private final Exercise exercise;
    private final List<byte[]> classes;
    private final long id;
    private final int trials;
    private final PacedWorld world;
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final PrintStream output = new PrintStream(bytes, true, StandardCharsets.UTF_8);
    private final List<SeededScore> judged = new ArrayList<>();
    private final Consumer<Grade> complete;
    private ExerciseTrial trial;
    private boolean closed;

    /**
     * Starts the first trial.
     *
     * @param exercise the exercise
     * @param classes class files of the program
     * @param id number of the attempt
     * @param trials number of trials, each with its own seed; at least 1
     * @param page receives the messages
     * @param complete receives the grade when all trials have been judged
     */
    ExerciseAttempt(
            Exercise exercise,
            List<byte[]> classes,
            long id,
            int trials,
            PageFeed.Page page,
            Consumer<Grade> complete) {
        this.exercise = exercise;
        this.classes = List.copyOf(classes);
        this.id = id;
        this.trials = trials;
        this.complete = complete;
        world = new PacedWorld(page, feed -> new FreePitch(SEED_OF_EMPTY_PITCH, feed, RecordingTarget.NONE));
        trial = next();
    }

    private ExerciseTrial next() {
        long seed = judged.size() + 1L;
        world.feed().judge(new TrialLabel(exercise.name(), id, seed));
        ExerciseTrial started = new ExerciseTrial(
                exercise,
                seed,
                () -> new StudentController(new Program(classes), output, world.feed()),
                PageContext.record());
        if (started.isStarted()) {
            world.show(started);
        }
        return started;
    }

    /** {@return the displayed world} */
    PacedWorld world() {
        return world;
    }

    /**
     * Advances the trial as far as the chosen speed and the processor allow, and updates the page.
     *
     * @param seconds time since the last call
     */
    void turn(double seconds) {
        world.turn(seconds);
        if (!closed && !isOver() && trial.isOver()) {
            judge();
        }
    }

    private void judge() {
        add(trial.score());
        while (trial.isStuck() && !isOver()) {
            add(Score.notTried());
        }
        if (isOver()) {
            complete.accept(status().grade());
        } else {
            trial = next();
        }
    }

    private void add(Score score) {
        judged.add(new SeededScore(judged.size() + 1L, score));
    }

    private boolean isOver() {
        return judged.size() == trials;
    }

    @Override
    public CourseHost.Status status() {
        String printed = bytes.toString(StandardCharsets.UTF_8);
        return new CourseHost.Status(
                isOver() ? CourseHost.State.OVER : CourseHost.State.RUNNING,
                0,
                new Grade(exercise.fullName(), judged),
                printed.substring(Math.max(0, printed.length() - MAX_CHARACTERS)));
    }

    @Override
    public void close() {
        closed = true;
    }
}
