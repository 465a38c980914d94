package org.robonewbie.exercises.progress;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.exercises.Exercise;

/**
 * The hints of an exercise's worksheet, which open one after the other.
 *
 * @param hints the hints in their order, without marks of Markdown
 */
public record Worksheet(List<String> hints) {

    private static final String HEADING = "## Hints";

    /** Takes a copy. */
    public Worksheet {
        hints = List.copyOf(hints);
    }

    /**
     * Reads a worksheet of the documentation.
     *
     * @param exercise the exercise
     * @return its hints; none if the program comes without worksheets
     */
    public static Worksheet of(Exercise exercise) {
        String file = "/org/robonewbie/exercises/worksheet/" + exercise.fullName() + ".md";
        try (@Nullable InputStream stream = Worksheet.class.getResourceAsStream(file)) {
            return stream == null
                    ? new Worksheet(List.of())
                    : parse(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException unreadable) {
            throw new UncheckedIOException("The worksheet " + file + " cannot be read.", unreadable);
        }
    }

    /** Takes the list below the heading "Hints"; lines that are indented belong to the one before. */
    static Worksheet parse(String markdown) {
        List<String> hints = new ArrayList<>();
        boolean inside = false;
        for (String line : markdown.lines().toList()) {
            if (line.startsWith("## ")) {
                inside = line.strip().equals(HEADING);
            } else if (inside && line.startsWith("- ")) {
                hints.add(plain(line.substring(2)));
            } else if (inside && line.startsWith("  ") && !hints.isEmpty()) {
                int last = hints.size() - 1;
                hints.set(last, hints.get(last) + " " + plain(line));
            }
        }
        return new Worksheet(hints);
    }

    private static String plain(String markdown) {
        return markdown.strip()
                .replaceAll("\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
                .replace("`", "")
                .replace("**", "");
    }
}
