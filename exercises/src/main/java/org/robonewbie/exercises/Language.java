package org.robonewbie.exercises;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * The language of worksheets and hints. Names, findings and messages are English in both.
 *
 * <p>Tasks write their hints in English; the file {@code hints-de.txt} has each of them with its translation below it.
 *
 * <pre>{@code
 * Language.GERMAN.hint(score.hint());
 * Language.GERMAN.worksheet(exercise);   // de/12-kick
 * }</pre>
 */
public enum Language {
    /** The language in which everything is written first. */
    ENGLISH("en"),
    /** A translation of worksheets and hints. */
    GERMAN("de");

    /** The environment variable with the language of all programs, such as {@code de}. */
    public static final String VARIABLE = "ROBONEWBIE_LANGUAGE";

    private static final Map<String, String> GERMAN_HINTS = read("hints-de.txt");

    private final String code;

    Language(String code) {
        this.code = code;
    }

    /** {@return two letters, such as {@code de}} */
    public String code() {
        return code;
    }

    /**
     * Finds a language.
     *
     * @param name its two letters, also as the beginning of a longer name such as {@code de_AT}
     * @return the language; empty if there is none of this name
     */
    public static Optional<Language> of(String name) {
        String wanted = name.toLowerCase(Locale.ROOT);
        return Arrays.stream(values())
                .filter(language -> wanted.matches(language.code + "([_.-].*)?"))
                .findFirst();
    }

    /**
     * Translates a hint.
     *
     * @param english the hint of a score
     * @return the hint in this language; in English if it has no translation
     */
    public String hint(String english) {
        return hints().getOrDefault(english, english);
    }

    /**
     * Names the worksheet of an exercise in this language.
     *
     * @param exercise the exercise
     * @return its path below {@code docs/exercises}, without an ending
     */
    public String worksheet(Exercise exercise) {
        return this == ENGLISH ? exercise.fullName() : code + "/" + exercise.fullName();
    }

    /** {@return all hints that have a translation, by their English text} */
    Map<String, String> hints() {
        return this == GERMAN ? GERMAN_HINTS : Map.of();
    }

    private static Map<String, String> read(String file) {
        Map<String, String> pairs = new HashMap<>();
        try (InputStream stream =
                Objects.requireNonNull(Language.class.getResourceAsStream(file), "There is no file " + file)) {
            for (String pair : new String(stream.readAllBytes(), StandardCharsets.UTF_8).split("\\R\\R", -1)) {
                String[] lines = pair.strip().split("\\R", -1);
                pairs.put(lines[0], lines[1]);
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException("The file " + file + " cannot be read.", unreadable);
        }
        return Map.copyOf(pairs);
    }
}
