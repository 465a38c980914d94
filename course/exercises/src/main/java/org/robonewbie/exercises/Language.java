package org.robonewbie.exercises;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * The language of worksheets, goals, hints and findings. Names and messages of programs are English in both.
 *
 * <p>Tasks speak English; {@code hints-de.txt} has each goal and hint with its translation below it, {@code findings-de.txt} what is
 * measured, with gaps for the figures.
 *
 * <pre>{@code
 * Language.GERMAN.translated(score.hint());
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

    private static final Translations NONE = Translations.empty();
    private static final Translations IN_GERMAN =
            Translations.read("/org/robonewbie/exercises/hints-de.txt", "/org/robonewbie/exercises/findings-de.txt");

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
     * Translates a goal, a hint or a finding.
     *
     * @param english the text in English
     * @return the text in this language; what has no translation stays English
     */
    public String translated(String english) {
        return phrases().translated(english);
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

    /** {@return what is translated} */
    Translations phrases() {
        return this == GERMAN ? IN_GERMAN : NONE;
    }
}
