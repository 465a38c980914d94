package org.robonewbie.exercises.progress;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;

/** Hints and solutions. */
class HelpTest {

    private static final Exercise KICK = Exercises.find("kick").orElseThrow();
    private static final ExerciseProgress TRIED = new ExerciseProgress(3, 2, false, 0, 0, false, "");

    @TempDir
    private Path folder;

    static List<Exercise> exercises() {
        return Exercises.all();
    }

    @BeforeEach
    void writeSolution() throws IOException {
        Files.writeString(folder.resolve("Kick.java"), "package org.robonewbie.somewhere;\n\npublic class Kick {}\n");
    }

    private SolutionRepository shelf() {
        return SolutionRepository.ofFolder(folder);
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void eachWorksheetHasTheSameHintsInAllLanguages(Exercise exercise) {
        List<String> english = Worksheet.of(exercise, Language.ENGLISH).hints();

        assertThat(english).isNotEmpty();
        for (Language language : Language.values()) {
            assertThat(Worksheet.of(exercise, language).hints())
                    .hasSameSizeAs(english)
                    .allSatisfy(hint -> assertThat(hint).isNotBlank().doesNotContain("`", "]("));
        }
    }

    @Test
    void hintsAreTheListBelowTheirHeading() {
        Worksheet sheet = Worksheet.parse("""
                # Exercise 12: Kick

                - no hint

                ## Hints

                - Use `a`, see
                  [b](c.md).
                - **Slow** down.

                ## A program

                - nothing
                """);

        assertThat(sheet.title()).isEqualTo("Kick");
        assertThat(sheet.hints()).containsExactly("Use a, see b.", "Slow down.");
    }

    @Test
    void solutionIsShownAfterThreeTriesOrASuccess() {
        assertThat(shelf().ask(KICK, ExerciseProgress.NONE).text()).contains("after 3 graded attempts: 3 more.");
        assertThat(shelf().ask(KICK, new ExerciseProgress(2, 2, false, 0, 0, false, ""))
                        .text())
                .endsWith("one more.");
        assertThat(shelf().ask(KICK, TRIED)).isEqualTo(new SolutionRepository.Answer(true, "public class Kick {}\n"));
        assertThat(shelf().ask(KICK, new ExerciseProgress(1, 10, true, 0, 0, false, ""))
                        .open())
                .isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"kick", "12", "12-kick", "all", "# later\n dance\n Kick is next\nALL"})
    void teacherLocksASolution(String lock) throws IOException {
        Files.writeString(folder.resolve("locked.txt"), lock);

        assertThat(shelf().ask(KICK, TRIED).text()).isEqualTo("Your teacher has locked the solution for kick for now.");
        assertThat(shelf().offers(KICK)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"UTF-8", "UTF-16LE", "UTF-16BE"})
    void lockIsReadWithAByteOrderMark(String encoding) throws IOException {
        Files.write(folder.resolve("locked.txt"), "\uFEFFkick\r\n# für später\r\n".getBytes(Charset.forName(encoding)));

        assertThat(shelf().offers(KICK)).isFalse();
    }

    @Test
    void lockThatNamesNoExerciseLocksAll() throws IOException {
        Files.writeString(folder.resolve("locked.txt"), "danse\n");

        assertThat(shelf().offers(KICK)).isFalse();
    }

    @Test
    void solutionOfAnyEditorIsShown() throws IOException {
        Files.write(folder.resolve("Kick.java"), "\uFEFFpublic class Kick {} // ü".getBytes(StandardCharsets.UTF_16LE));

        assertThat(shelf().ask(KICK, TRIED).text()).isEqualTo("public class Kick {} // ü");
    }

    @Test
    void lockOfAnotherExerciseDoesNotMatter() throws IOException {
        Files.writeString(folder.resolve("locked.txt"), "dance\n1\n");

        assertThat(shelf().offers(KICK)).isTrue();
        assertThat(shelf().ask(KICK, TRIED).open()).isTrue();
    }

    @Test
    void withoutSolutionsTheTeacherIsAsked() {
        SolutionRepository none = SolutionRepository.NONE;

        assertThat(none.offers(KICK)).isFalse();
        assertThat(none.ask(KICK, TRIED).text()).contains("Ask your teacher");
    }
}
