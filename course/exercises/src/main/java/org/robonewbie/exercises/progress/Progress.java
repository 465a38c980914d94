package org.robonewbie.exercises.progress;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.simulator.json.Json;

/**
 * A student's progress in all exercises.
 *
 * @param exercises the states by exercise name, only for exercises that have been started
 */
public record Progress(Map<String, ExerciseProgress> exercises) {

    private static final int VERSION = 1;

    /** Defensively copies the map. */
    public Progress {
        exercises = Collections.unmodifiableMap(new TreeMap<>(exercises));
    }

    /**
     * Parses JSON. Skips exercises with invalid values.
     *
     * @param text JSON as written by {@link #json()}
     * @return the progress; empty if the text is not JSON in this format
     */
    public static Optional<Progress> parse(String text) {
        try {
            JsonElement json = JsonParser.parseString(text);
            if (!json.isJsonObject() || !json.getAsJsonObject().has("exercises")) {
                return Optional.empty();
            }
            Map<String, ExerciseProgress> states = new TreeMap<>();
            json.getAsJsonObject()
                    .getAsJsonObject("exercises")
                    .entrySet()
                    .forEach(entry -> state(entry.getValue()).ifPresent(state -> states.put(entry.getKey(), state)));
            return Optional.of(new Progress(states));
        } catch (JsonParseException | ClassCastException noProgress) {
            return Optional.empty();
        }
    }

    private static Optional<ExerciseProgress> state(JsonElement json) {
        if (!json.isJsonObject()) {
            return Optional.empty();
        }
        JsonObject state = json.getAsJsonObject();
        try {
            return Optional.of(new ExerciseProgress(
                    (int) number(state, "tries"),
                    number(state, "bestPoints"),
                    state.has("passed") && state.get("passed").getAsBoolean(),
                    (long) number(state, "seconds"),
                    (int) number(state, "hints"),
                    state.has("solutionSeen") && state.get("solutionSeen").getAsBoolean(),
                    state.has("lastSeen") ? state.get("lastSeen").getAsString() : ""));
        } catch (RuntimeException invalid) {
            return Optional.empty();
        }
    }

    private static double number(JsonObject state, String name) {
        return state.has(name) ? state.get(name).getAsDouble() : 0;
    }

    /** {@return the progress as JSON} */
    public JsonObject json() {
        JsonObject states = new JsonObject();
        exercises.forEach((name, state) -> states.add(name, json(state)));
        return Json.object("version", VERSION, "exercises", states);
    }

    private static JsonObject json(ExerciseProgress state) {
        return Json.object(
                "tries", state.tries(),
                "bestPoints", state.bestPoints(),
                "passed", state.passed(),
                "seconds", state.seconds(),
                "hints", state.hints(),
                "solutionSeen", state.solutionSeen(),
                "lastSeen", state.lastSeen());
    }

    /**
     * Returns the state of one exercise.
     *
     * @param exercise the exercise
     * @return its state
     */
    public ExerciseProgress of(Exercise exercise) {
        return exercises.getOrDefault(exercise.name(), ExerciseProgress.NONE);
    }

    /**
     * Replaces the state of one exercise.
     *
     * @param exercise the exercise
     * @param state its new state
     * @return the new progress
     */
    public Progress with(Exercise exercise, ExerciseProgress state) {
        Map<String, ExerciseProgress> changed = new TreeMap<>(exercises);
        changed.put(exercise.name(), state);
        return new Progress(changed);
    }

    /** {@return the number of exercises passed} */
    public long passed() {
        return Exercises.all().stream().filter(each -> of(each).passed()).count();
    }

    /** {@return the sum of the points scored in the best try of each exercise} */
    public double points() {
        return Exercises.all().stream()
                .mapToDouble(each -> of(each).bestPoints())
                .sum();
    }

    /** {@return the working time for all exercises, in seconds} */
    public long seconds() {
        return Exercises.all().stream().mapToLong(each -> of(each).seconds()).sum();
    }

    /** {@return the badges earned} */
    public List<Badge> badges() {
        return Arrays.stream(Badge.values())
                .filter(badge -> badge.isEarnedBy(this))
                .toList();
    }

    /**
     * Merges the progress of two team members, taking the better state for each exercise.
     *
     * @param other progress of another member
     * @return the team's progress
     */
    public Progress joined(Progress other) {
        Map<String, ExerciseProgress> both = new TreeMap<>(exercises);
        other.exercises.forEach((name, state) -> both.merge(name, state, Progress::joined));
        return new Progress(both);
    }

    private static ExerciseProgress joined(ExerciseProgress one, ExerciseProgress other) {
        return new ExerciseProgress(
                one.tries() + other.tries(),
                Math.max(one.bestPoints(), other.bestPoints()),
                one.passed() || other.passed(),
                one.seconds() + other.seconds(),
                Math.max(one.hints(), other.hints()),
                one.solutionSeen() || other.solutionSeen(),
                one.lastSeen().compareTo(other.lastSeen()) > 0 ? one.lastSeen() : other.lastSeen());
    }
}
