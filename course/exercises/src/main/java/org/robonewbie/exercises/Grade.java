package org.robonewbie.exercises;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * Grade for an exercise.
 *
 * @param exercise full name of the exercise
 * @param trials one score per seed, in the order of the seeds
 */
public record Grade(String exercise, List<SeededScore> trials) {

    /**
     * Score of one trial.
     *
     * @param seed seed of all random numbers
     * @param score the score
     */
    public record SeededScore(long seed, Score score) {}

    /** Creates a grade. */
    public Grade {
        trials = List.copyOf(trials);
    }

    /** {@return whether all trials passed} */
    public boolean passed() {
        return !trials.isEmpty()
                && trials.stream().allMatch(trial -> trial.score().passed());
    }

    /** {@return the mean points of the trials, 0 to 10} */
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
     * Parses the output of {@link #json}.
     *
     * @param json JSON text
     * @return the grade
     */
    public static Grade ofJson(String json) {
        Printed printed = gson().fromJson(json, Printed.class);
        return new Grade(printed.exercise, printed.trials);
    }

    /** Returns the grade as English text. */
    @Override
    public String toString() {
        return text(Language.ENGLISH);
    }

    /**
     * Returns the grade as text.
     *
     * @param language language of the text
     * @return one line per trial, the result, and each distinct hint
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
                Score.MAX_POINTS,
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
