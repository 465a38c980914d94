package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Each hint and each worksheet is there in all languages. */
class LanguageTest {

    private static final Pattern JOINED = Pattern.compile("\"\\s*\\+\\s*\"");
    private static final Pattern SENTENCE =
            Pattern.compile("\"([A-Z0-9](?:[^\"\\\\]|\\\\.)* (?:[^\"\\\\]|\\\\.)*[.?])\"");

    private static final String MEND = "Mend this first; the rest was not tried.";

    static Stream<String> hintsOfTasks() throws IOException {
        try (Stream<Path> tasks = Files.list(Path.of("src/main/java/org/robonewbie/exercises/task"))) {
            return tasks.map(LanguageTest::read).flatMap(LanguageTest::sentences).toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("hintsOfTasks")
    void hintHasATranslation(String hint) {
        assertThat(Language.GERMAN.hint(hint)).isNotEqualTo(hint);
    }

    @Test
    void noTranslationIsLeftOver() throws IOException {
        String sources;
        try (Stream<Path> files = Files.walk(Path.of("src/main/java/org/robonewbie/exercises"))) {
            sources = files.filter(Files::isRegularFile).map(LanguageTest::read).reduce("", String::concat);
        }

        assertThat(Language.GERMAN.hints()).hasSizeGreaterThan(30).allSatisfy((english, german) -> {
            assertThat(sources).contains("\"" + english.replace("\"", "\\\"") + "\"");
            assertThat(german).isNotBlank();
        });
    }

    @Test
    void gradeIsTranslatedButForItsFindings() {
        Grade grade = new Grade("12-kick", List.of(new Grade.SeededScore(1, Score.failed(0, "found", MEND))));

        assertThat(grade.in(Language.GERMAN).toString())
                .contains("found", "Hint: Behebe zuerst das")
                .doesNotContain(MEND);
        assertThat(grade.in(Language.ENGLISH)).isEqualTo(grade);
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void eachExerciseHasAWorksheet(Language language) {
        assertThat(Exercises.all())
                .allMatch(exercise -> Files.exists(Path.of("../docs/exercises", language.worksheet(exercise) + ".md")));
    }

    @Test
    void languageIsFoundByItsLetters() {
        assertThat(Language.of("de")).contains(Language.GERMAN);
        assertThat(Language.of("de_AT.UTF-8")).contains(Language.GERMAN);
        assertThat(Language.of("EN")).contains(Language.ENGLISH);
        assertThat(Language.of("denglish")).isEqualTo(Optional.empty());
    }

    private static Stream<String> sentences(String source) {
        return SENTENCE.matcher(source)
                .results()
                .map(match -> match.group(1).replace("\\\"", "\""))
                .filter(sentence -> !sentence.contains("%"));
    }

    /** The text of a source, with texts that go over several lines in one piece. */
    private static String read(Path file) {
        try {
            return JOINED.matcher(Files.readString(file)).replaceAll("");
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
