package org.robonewbie.exercises;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * Language of worksheets, goals, hints and findings. Names and messages of programs are always English.
 *
 * <p>Tasks produce English text. German translations of goals and hints are in {@code hints-de.txt}, those of findings,
 * with placeholders for the measured values, in {@code findings-de.txt}.
 *
 * <pre>{@code
 * Language.GERMAN.translated(score.hint());
 * Language.GERMAN.worksheet(exercise);   // de/12-kick
 * }</pre>
 */
public enum Language {
    /** The source language. */
    ENGLISH("en"),
    /** German translation. */
    GERMAN("de");

    /** Environment variable with the default language, such as {@code de}. */
    public static final String VARIABLE = "ROBONEWBIE_LANGUAGE";

    private static final Translations NONE = Translations.empty();
    private static final Translations IN_GERMAN =
            Translations.read("/org/robonewbie/exercises/hints-de.txt", "/org/robonewbie/exercises/findings-de.txt");

    private final String code;

    Language(String code) {
        this.code = code;
    }

    /** {@return the ISO 639-1 code, such as {@code de}} */
    public String code() {
        return code;
    }

    /**
     * Finds a language.
     *
     * @param name ISO 639-1 code, or a locale that starts with it, such as {@code de_AT}
     * @return the language; empty if it is not supported
     */
    public static Optional<Language> of(String name) {
        String wanted = name.toLowerCase(Locale.ROOT);
        return Arrays.stream(values())
                .filter(language -> wanted.matches(language.code + "([_.-].*)?"))
                .findFirst();
    }

    /**
     * Translates a goal, hint or finding.
     *
     * @param english English text
     * @return the text in this language; parts without a translation stay in English
     */
    public String translated(String english) {
        return phrases().translated(english);
    }

    /**
     * Returns the path of an exercise's worksheet.
     *
     * @param exercise the exercise
     * @return path below {@code docs/exercises}, without extension
     */
    public String worksheet(Exercise exercise) {
        return this == ENGLISH ? exercise.fullName() : code + "/" + exercise.fullName();
    }

    /** {@return the translated phrases} */
    Translations phrases() {
        return this == GERMAN ? IN_GERMAN : NONE;
    }
}
