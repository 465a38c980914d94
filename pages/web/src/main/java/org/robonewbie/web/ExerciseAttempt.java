package org.robonewbie.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade.SeededScore;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.Score;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.studio.PageFeed;

/** Trials of one exercise with consecutive seeds, shown to the student. */
final class ExerciseAttempt {

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
    private ExerciseTrial trial;

    /**
     * Starts the first trial.
     *
     * @param exercise the exercise
     * @param classes class files of the program
     * @param id number of the attempt
     * @param trials number of seeds, at least 1
     * @param page receives the messages
     */
    ExerciseAttempt(Exercise exercise, List<byte[]> classes, long id, int trials, PageFeed.Page page) {
        this.exercise = exercise;
        this.classes = List.copyOf(classes);
        this.id = id;
        this.trials = trials;
        world = new PacedWorld(page, feed -> new FreePitch(SEED_OF_EMPTY_PITCH, feed, RecordingTarget.NONE));
        trial = next();
    }

    /**
     * Judges one trial as fast as possible.
     *
     * @param exercise the exercise
     * @param classes class files of the program
     * @param seed random seed
     * @return the score
     */
    static Score score(Exercise exercise, List<byte[]> classes, long seed) {
        PrintStream nowhere = new PrintStream(new ByteArrayOutputStream());
        ExerciseTrial trial = new ExerciseTrial(
                exercise,
                seed,
                () -> new StudentController(new Program(classes), nowhere, TelemetrySink.NONE),
                RecordingTarget.NONE);
        while (!trial.isOver()) {
            trial.cycle();
        }
        return trial.score();
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
        if (!isOver() && trial.isOver()) {
            judge();
        }
    }

    private void judge() {
        add(trial.score());
        while (trial.isStuck() && !isOver()) {
            add(Score.notTried());
        }
        if (!isOver()) {
            trial = next();
        }
    }

    private void add(Score score) {
        judged.add(new SeededScore(judged.size() + 1L, score));
    }

    private boolean isOver() {
        return judged.size() == trials;
    }

    /**
     * Returns the state of the attempt.
     *
     * @param language language of findings and hints
     * @return one JSON object: state, number of trials, results, and output of the program
     */
    String json(Language language) {
        JsonObject json = new JsonObject();
        json.addProperty("id", id);
        json.addProperty("state", isOver() ? "OVER" : "RUNNING");
        json.addProperty("exercise", exercise.name());
        json.addProperty("trials", trials);
        JsonArray scores = new JsonArray();
        judged.forEach(each -> scores.add(json(each.seed(), each.score().in(language))));
        json.add("judged", scores);
        String said = bytes.toString(StandardCharsets.UTF_8);
        json.addProperty("output", said.substring(Math.max(0, said.length() - MAX_CHARACTERS)));
        return json.toString();
    }

    /** Writes a score as JSON. */
    static JsonObject json(long seed, Score score) {
        JsonObject json = new JsonObject();
        json.addProperty("seed", seed);
        json.addProperty("passed", score.passed());
        json.addProperty("points", score.points());
        json.addProperty("finding", score.finding());
        json.addProperty("hint", score.hint());
        return json;
    }
}
