package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.exercises.progress.Worksheet;

/** What the grader says and each worksheet is there in all languages. */
class LanguageTest {

    private static final Pattern JOINED = Pattern.compile("\"\\s*\\+\\s*\"");
    private static final Pattern SENTENCE =
            Pattern.compile("\"([A-Z0-9](?:[^\"\\\\]|\\\\.)* (?:[^\"\\\\]|\\\\.)*[.?])\"");

    private static final Pattern TEXT = Pattern.compile("\"((?:[^\"\\\\]|\\\\.)*)\"");
    private static final Path SOURCES = Path.of("src/main/java/org/robonewbie/exercises");

    private static final String FIX_FIRST = "Fix this first; the remaining checks were skipped.";

    static Stream<String> hintsOfTasks() throws IOException {
        try (Stream<Path> files = Files.list(SOURCES)) {
            return files
                    .filter(file -> file.toString().endsWith("Task.java"))
                    .map(LanguageTest::read)
                    .flatMap(LanguageTest::sentences)
                    .toList()
                    .stream();
        }
    }

    @ParameterizedTest
    @MethodSource("hintsOfTasks")
    void hintHasATranslation(String hint) {
        assertThat(Language.GERMAN.translated(hint)).isNotEqualTo(hint);
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void exerciseHasATranslation(Exercise exercise) {
        assertThat(Language.GERMAN.translated(exercise.goal())).isNotEqualTo(exercise.goal());
        assertThat(Language.GERMAN.translated(exercise.level())).isNotEqualTo(exercise.level());
        assertThat(Worksheet.of(exercise, Language.ENGLISH).title()).isEqualTo(exercise.title());
        assertThat(Worksheet.of(exercise, Language.GERMAN).title()).isNotBlank();
    }

    static List<Exercise> exercises() {
        return Exercises.all();
    }

    static Stream<String> findingsOfTasks() throws IOException {
        try (Stream<Path> files = Files.list(SOURCES)) {
            return files
                    .filter(file -> file.toString().endsWith("Task.java"))
                    .map(LanguageTest::read)
                    .flatMap(LanguageTest::clauses)
                    .distinct()
                    .toList()
                    .stream();
        }
    }

    @ParameterizedTest
    @MethodSource("findingsOfTasks")
    void findingHasATranslation(String clause) {
        Pattern phrase = Pattern.compile("\\Q" + clause.replace("%s", "\\E.*\\Q") + "\\E");

        boolean translated = Language.GERMAN.phrases().phrases().keySet().stream()
                .anyMatch(english -> phrase.matcher(english).find());

        assertThat(translated).as(clause).isTrue();
    }

    @Test
    void noTranslationIsLeftOver() throws IOException {
        String sources;
        try (Stream<Path> files = Files.walk(SOURCES)) {
            sources = files.filter(Files::isRegularFile).map(LanguageTest::read).reduce("", String::concat);
        }

        assertThat(Translations.read("/org/robonewbie/exercises/hints-de.txt").phrases())
                .hasSizeGreaterThan(30)
                .allSatisfy((english, german) -> {
                    assertThat(sources).contains("\"" + english.replace("\"", "\\\"") + "\"");
                    assertThat(german).isNotBlank();
                });
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "left arm 3.1° too low and still moving, right arm 0.2° off (tolerance 2°)"
                        + "|linker Arm 3.1° zu tief und noch in Bewegung, rechter Arm 0.2° daneben (2° sind erlaubt)",
                "lay on its back and said nothing; stood after 4.2 s, but did not say \"up\""
                        + "|lag auf dem Rücken und sagte nichts; stand nach 4.2 s, sagte aber nicht \"up\"",
                "ball in front of the left foot: it went 0.12 m, the robot moved 0.40 m and fell to the right after 1.2 s"
                        + "|Ball vor dem linken Fuß: er rollte 0.12 m, der Roboter bewegte sich 0.40 m und fiel nach 1.2 s nach rechts",
                "saved the first shot; conceded the second, 0.55 m to the left"
                        + "|hielt den ersten Schuss; ein Tor durch den zweiten, 0.55 m links",
                "saved the shots 0.55 m to the left and 0.61 m to the right of the middle"
                        + "|hielt die Schüsse 0.55 m links und 0.61 m rechts der Mitte",
                "head turned to the ball for 90 % of the time, arm from -31° to 32°, once every 2.00 s"
                        + "|Kopf in 90 % der Zeit beim Ball, Arm von -31° bis 32°, einmal in 2.00 s",
                "The program ended with java.lang.ArithmeticException: / by zero in Kick.java:12."
                        + "|Das Programm endete mit java.lang.ArithmeticException: / by zero in Kick.java:12.",
                "The program ended the whole process (exit code 0). Does it call System.exit?"
                        + "|Das Programm hat den ganzen Prozess beendet (Exit-Code 0). Ruft es System.exit auf?",
                "1 of 2 gates, 0.40 m from the ball at best, objects moved by 0.00 m, 24 s"
                        + "|1 von 2 Toren, kam dem Ball bis auf 0.40 m nahe, Hindernisse um 0.00 m verschoben, 24 s",
                "reached the top, and stood there for 3 s|erreichte die Kuppe, und stand dort 3 s",
                "nobody has written this|nobody has written this"
            })
    void findingIsTranslatedWithItsFigures(String english, String german) {
        assertThat(Language.GERMAN.translated(english)).isEqualTo(german);
    }

    @Test
    void gradeIsToldInBothLanguages() {
        Grade grade = new Grade("12-kick", List.of(new Grade.SeededScore(1, Score.failed(0, "no goal", FIX_FIRST))));

        assertThat(grade.text(Language.GERMAN))
                .isEqualTo(String.join(
                        System.lineSeparator(),
                        "  Startzahl 1   verfehlt  0 Punkte  kein Tor",
                        "12-kick noch nicht bestanden: 0.0 von 10 Punkte",
                        "Hinweis: Behebe zuerst das; der Rest wurde nicht versucht.",
                        ""));
        assertThat(grade.text(Language.ENGLISH)).isEqualTo(grade.toString()).contains("of 10 points", FIX_FIRST);
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void eachExerciseHasAWorksheet(Language language) {
        assertThat(Exercises.all())
                .allMatch(exercise ->
                        Files.exists(Path.of("../../docs/exercises", language.worksheet(exercise) + ".md")));
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void indexListsTitleTimeAndGoalOfEachExercise(Language language) {
        Path worksheet = Path.of(
                "../../docs/exercises", language.worksheet(Exercises.all().get(0)));
        String rows = Exercises.all().stream()
                .map(exercise -> String.format(
                        "| %d | [%s](%s.md) | %d | %s |\n",
                        exercise.number(),
                        Worksheet.of(exercise, language).title(),
                        exercise.fullName(),
                        exercise.minutes(),
                        language.translated(exercise.goal())))
                .collect(Collectors.joining());

        assertThat(worksheet.resolveSibling("README.md")).content().contains(rows);
    }

    @Test
    void languageIsFoundByItsLetters() {
        assertThat(Language.of("de")).contains(Language.GERMAN);
        assertThat(Language.of("de_AT.UTF-8")).contains(Language.GERMAN);
        assertThat(Language.of("EN")).contains(Language.ENGLISH);
        assertThat(Language.of("denglish")).isEqualTo(Optional.empty());
    }

    /** What a task measures, in the pieces between commas, with all figures as gaps. */
    private static Stream<String> clauses(String source) {
        return TEXT.matcher(source.replaceAll("(?m)^\\s*(//|/?\\*).*", ""))
                .results()
                .map(match -> match.group(1))
                .filter(text ->
                        text.contains(" ") && !Character.isUpperCase(text.charAt(0)) && !text.startsWith("10 points"))
                .map(text -> text.replace("\\\"", "\"")
                        .replaceAll("%(\\.\\d)?[sdf]", "%s")
                        .replace("%%", "%"))
                .flatMap(text -> Stream.of(text.split("[,;:] ?")))
                .map(String::strip)
                .filter(clause -> clause.matches(".*[a-z]{2}.*") && !clause.contains(" + "));
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
