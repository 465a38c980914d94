package org.robonewbie.exercises.progress;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Language;

/**
 * Worksheet of an exercise.
 *
 * @param title the title, without its number
 * @param hints the hints in the order in which they are revealed, without Markdown markup
 */
public record Worksheet(String title, List<String> hints) {

    private static final String TITLE = "# ";
    private static final Set<String> HINTS = Set.of("## Hints", "## Hinweise");

    /** Defensively copies the list. */
    public Worksheet {
        hints = List.copyOf(hints);
    }

    /**
     * Reads a worksheet from the documentation.
     *
     * @param exercise the exercise
     * @param language the language of the worksheet
     * @return its title and hints; the English title without hints if the program was built without worksheets
     */
    public static Worksheet of(Exercise exercise, Language language) {
        String file = "/org/robonewbie/exercises/worksheet/" + language.worksheet(exercise) + ".md";
        try (@Nullable InputStream stream = Worksheet.class.getResourceAsStream(file)) {
            return stream == null
                    ? new Worksheet(exercise.title(), List.of())
                    : parse(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException unreadable) {
            throw new UncheckedIOException("The worksheet " + file + " cannot be read.", unreadable);
        }
    }

    /** Parses the title and the list below the hints heading. An indented line continues the previous item. */
    static Worksheet parse(String markdown) {
        String title = "";
        List<String> hints = new ArrayList<>();
        boolean inside = false;
        for (String line : markdown.split("\n", -1)) {
            if (line.startsWith(TITLE)) {
                title = line.substring(line.indexOf(':') + 1).strip();
            } else if (line.startsWith("## ")) {
                inside = HINTS.contains(line.strip());
            } else if (inside && line.startsWith("- ")) {
                hints.add(line.substring(2).strip());
            } else if (inside && line.startsWith("  ") && !hints.isEmpty()) {
                int last = hints.size() - 1;
                hints.set(last, hints.get(last) + " " + line.strip());
            }
        }
        return new Worksheet(title, hints.stream().map(Worksheet::plain).toList());
    }

    private static String plain(String markdown) {
        return markdown.replaceAll("\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
                .replace("`", "")
                .replace("**", "");
    }
}
