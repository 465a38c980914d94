package org.robonewbie.exercises.progress;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Score;
import org.robonewbie.nao.text.Csv;

/**
 * Formats progress as text for students and as a CSV table for teachers.
 *
 * @param progress the progress
 */
public record ProgressTable(Progress progress) {

    private static final int SECONDS_PER_MINUTE = 60;
    private static final int MINUTES_PER_HOUR = 60;

    /** {@return one line per exercise, followed by the totals and the badges} */
    public String text() {
        List<String> lines = new ArrayList<>();
        for (Exercise exercise : Exercises.all()) {
            lines.add(line(exercise, progress.of(exercise)));
        }
        lines.add("");
        lines.add(sum());
        lines.add(
                progress.badges().isEmpty()
                        ? "No badges yet: pass an exercise to earn the first one."
                        : "Badges: "
                                + progress.badges().stream()
                                        .map(badge -> badge.title() + " (" + badge.reason() + ")")
                                        .collect(Collectors.joining(", ")));
        return lines.stream().map(line -> line + System.lineSeparator()).collect(Collectors.joining());
    }

    /** {@return a sentence with the totals of exercises passed, points and working time} */
    public String sum() {
        return String.format(
                Locale.ROOT,
                "%d of %d exercises passed, %.1f of %d points, %s",
                progress.passed(),
                Exercises.all().size(),
                progress.points(),
                Exercises.all().size() * Score.MAX_POINTS,
                time(progress.seconds()));
    }

    /** {@return the titles of the badges} */
    public List<String> badges() {
        return progress.badges().stream().map(Badge::title).toList();
    }

    /**
     * Formats the table for the teacher.
     *
     * @param name name of the student
     * @return the table as CSV
     */
    public String csv(String name) {
        List<String> lines = new ArrayList<>(List.of(Csv.line(Stream.of(
                "name", "exercise", "passed", "best points", "tries", "minutes", "hints", "solution seen", "last"))));
        for (Exercise exercise : Exercises.all()) {
            ExerciseProgress state = progress.of(exercise);
            lines.add(Csv.line(Stream.of(
                    name,
                    exercise.fullName(),
                    state.passed() ? "yes" : "no",
                    String.format(Locale.ROOT, "%.1f", state.bestPoints()),
                    String.valueOf(state.tries()),
                    String.valueOf(minutes(state.seconds())),
                    String.valueOf(state.hints()),
                    state.solutionSeen() ? "yes" : "no",
                    state.lastSeen())));
        }
        return Csv.text(lines);
    }

    private static String line(Exercise exercise, ExerciseProgress state) {
        String title = String.format(Locale.ROOT, "%3d %-40s", exercise.number(), exercise.title());
        if (state.tries() == 0) {
            return title + " -";
        }
        return String.format(
                Locale.ROOT,
                "%s %-6s %4.1f points  %2d %-5s  %s%s",
                title,
                state.passed() ? "passed" : "begun",
                state.bestPoints(),
                state.tries(),
                state.tries() == 1 ? "try" : "tries",
                time(state.seconds()),
                state.solutionSeen() ? "  (solution seen)" : "");
    }

    private static long minutes(long seconds) {
        return Math.round((double) seconds / SECONDS_PER_MINUTE);
    }

    private static String time(long seconds) {
        long minutes = minutes(seconds);
        return minutes < MINUTES_PER_HOUR
                ? minutes + " min"
                : minutes / MINUTES_PER_HOUR + " h " + minutes % MINUTES_PER_HOUR + " min";
    }
}
