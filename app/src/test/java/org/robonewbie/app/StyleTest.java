package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.app.command.RoboNewbieCommand;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.nao.Joint;

/** Pages, help and exercises are English that people speak: {@code docs/style.md} has the list of words. */
class StyleTest {

    private static final Pattern NOT_ENGLISH = Pattern.compile(
            "\\b(who wants to|who wants|shall|anew|the own|an own|in own words|each third|each second one|whosoever|informations"
                    + "|tells of|is told in|are told|and told|told so|in the mean|in earnest|one's own|at the least)\\b",
            Pattern.CASE_INSENSITIVE);

    static Stream<Path> pages() {
        return Project.pages().stream().filter(page -> !page.endsWith("docs/style.md"));
    }

    @ParameterizedTest
    @MethodSource("pages")
    void pageHasNoWordOfTheList(Path page) {
        assertThat(Project.read(page).lines().filter(StyleTest::isForeign))
                .as(page.toString())
                .isEmpty();
    }

    @Test
    void helpOfNoCommandHasAWordOfTheList() {
        assertThat(RoboNewbieCommand.commandLine().getSubcommands().values())
                .allSatisfy(
                        command -> assertThat(command.getUsageMessage().lines().filter(StyleTest::isForeign))
                                .isEmpty());
    }

    @Test
    void goalOfNoExerciseHasAWordOfTheList() {
        assertThat(Exercises.all()).noneMatch(exercise -> isForeign(exercise.goal()));
    }

    @Test
    void everyJointIsInThePictureWithItsRange() {
        String picture = Project.read(Project.ROOT.resolve("docs/images/joints.svg"));

        assertThat(Joint.values())
                .allSatisfy(joint -> assertThat(picture)
                        .contains(">" + joint + "<")
                        .contains(String.format(
                                "%.0f° to %.0f°  (%s)", joint.minDegrees(), joint.maxDegrees(), joint.standardName())));
    }

    @Test
    void drawingsHaveTheirOwnGroundInLightAndDark() {
        List<String> drawings = List.of(
                "architecture",
                "camera",
                "field",
                "joints",
                "keyframes",
                "message-cycle",
                "pendulum",
                "sense-think-act");

        assertThat(drawings)
                .map(name -> Project.read(Project.ROOT.resolve("docs/images/" + name + ".svg")))
                .allMatch(picture -> picture.contains("class=\"bg\"") && picture.contains("prefers-color-scheme:dark"));
    }

    private static boolean isForeign(String line) {
        return NOT_ENGLISH.matcher(line).find();
    }
}
