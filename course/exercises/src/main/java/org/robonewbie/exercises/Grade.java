package org.robonewbie.exercises;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * Grade of an exercise.
 *
 * @param exercise full name of the exercise
 * @param trials one line for each seed, in their order
 */
public record Grade(String exercise, List<SeededScore> trials) {

    /**
     * The score of one trial.
     *
     * @param seed seed of the trial
     * @param score its score
     */
    public record SeededScore(long seed, Score score) {}

    /** Copies the list. */
    public Grade {
        trials = List.copyOf(trials);
    }

    /** {@return whether all trials passed} */
    public boolean passed() {
        return !trials.isEmpty()
                && trials.stream().allMatch(trial -> trial.score().passed());
    }

    /** {@return the mean of the trials' points, 0 to 10} */
    public double points() {
        return trials.stream()
                .mapToInt(trial -> trial.score().points())
                .average()
                .orElse(0);
    }

    /**
     * Returns the grade as JSON.
     *
     * @return JSON with {@code exercise}, {@code passed}, {@code points} and {@code trials}
     */
    public String json() {
        return gson().toJson(new Printed(exercise, passed(), points(), trials)) + "\n";
    }

    /**
     * Parses the result of {@link #json}.
     *
     * @param json the text
     * @return the grade
     */
    public static Grade ofJson(String json) {
        Printed printed = gson().fromJson(json, Printed.class);
        return new Grade(printed.exercise, printed.trials);
    }

    /** Returns the grade in English words. */
    @Override
    public String toString() {
        return text(Language.ENGLISH);
    }

    /**
     * Returns the grade in words.
     *
     * @param language the language of the words
     * @return a line for each trial, the result, and each hint once
     */
    public String text(Language language) {
        List<SeededScore> told = trials.stream()
                .map(trial -> new SeededScore(trial.seed(), trial.score().in(language)))
                .toList();
        String lines = told.stream().map(trial -> line(trial, language)).collect(Collectors.joining());
        String result = String.format(
                Locale.ROOT,
                "%s %s: %.1f %s %d %s%n",
                exercise,
                language.translated(passed() ? "PASSED" : "not yet passed"),
                points(),
                language.translated("of"),
                Score.MOST_POINTS,
                language.translated("points"));
        String hints = told.stream()
                .map(trial -> trial.score().hint())
                .filter(hint -> !hint.isEmpty())
                .distinct()
                .map(hint -> String.format("%s: %s%n", language.translated("Hint"), hint))
                .collect(Collectors.joining());
        return lines + result + hints;
    }

    private static String line(SeededScore trial, Language language) {
        Score score = trial.score();
        return String.format(
                "  %s %-3d %-6s %2d %s  %s%n",
                language.translated("seed"),
                trial.seed(),
                language.translated(score.passed() ? "passed" : "failed"),
                score.points(),
                language.translated("points"),
                score.finding());
    }

    private static Gson gson() {
        return new GsonBuilder().setPrettyPrinting().create();
    }

    private record Printed(String exercise, boolean passed, double points, List<SeededScore> trials) {}
}
