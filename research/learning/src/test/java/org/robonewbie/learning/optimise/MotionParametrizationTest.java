package org.robonewbie.learning.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;

class MotionParametrizationTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        "kick-right, kick-distance",
        "kick-left, time-to-score",
        "walk-forward, walk-speed",
        "side-step-left, stability",
        "stand-up-from-front, energy",
        "fall-back, energy",
        "wave, stability"
    })
    void motionsOfTheLibrarySucceedAsTheyAre(String name, String objective) {
        MotionParametrization subject = subject(name, NamedObjective.named(objective));

        Evaluation evaluation = subject.evaluate(new double[subject.dimension()], 3);

        assertThat(evaluation.success()).isEqualTo(1);
        assertThat(evaluation).isEqualTo(subject.evaluate(new double[subject.dimension()], 3));
    }

    @Test
    void measuresAWalkAsFastAsItIs() {
        MotionParametrization subject = subject("walk-forward-fast", NamedObjective.named("walk-speed"));

        assertThat(subject.evaluate(new double[subject.dimension()], 1).value()).isCloseTo(0.38, within(0.03));
    }

    @Test
    void aMotionThatShallNeedLessEnergyMustGoOnDoingWhatItDid() {
        MotionParametrization kick = subject("kick-right", NamedObjective.named("energy"));
        double[] other = new double[kick.dimension()];
        other[22 * 2] = 8;

        Evaluation before = kick.evaluate(new double[kick.dimension()], 1);
        Evaluation after = kick.evaluate(other, 1);

        assertThat(after.flaws()).isGreaterThan(before.flaws() + 0.2);
    }

    @Test
    void refusesToMeasureAKickWithoutBall() {
        assertThatThrownBy(() -> subject("wave", NamedObjective.named("kick-distance")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "wave.txt does not define the position of the ball, so kick-distance cannot be measured. Add a line such as:"
                                + " // ball: 0.190 m ahead, -0.055 m to the left");
    }

    @Test
    void refusesAMotionOfOneKeyframe() {
        MotionFile one = MotionFile.parse("one.txt", "200" + " 0".repeat(22) + "\n");

        assertThatThrownBy(() -> new MotionParametrization("one.txt", one, NamedObjective.named("energy")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("one.txt has fewer than two keyframes");
    }

    @Test
    void keepsTheFilesCommentsButNotItsOldFigures() throws IOException {
        MotionFile file = MotionFile.parse(
                "mine.txt",
                "// measured: long ago\n// my kick\n"
                        + ShippedMotions.file("kick-right").text().replace("// measured", "// once measured"));
        MotionParametrization subject =
                new MotionParametrization("mine.txt", file, NamedObjective.named("kick-distance"));
        Path target = folder.resolve("new.txt");

        subject.save(new double[subject.dimension()], Map.of("made by", "test"), target);

        assertThat(Files.readString(target))
                .contains("// my kick")
                .contains("// made by: test")
                .doesNotContain("long ago");
        assertThat(MotionFiles.load(target).keyframes()).isEqualTo(file.keyframes());
    }

    @Test
    void writesTheOtherSideToo() throws IOException {
        Path right = folder.resolve("kick-right.txt");
        MotionFiles.save(ShippedMotions.file("kick-right"), right);

        OtherSide.write(right);

        MotionFile left = MotionFiles.load(folder.resolve("kick-left.txt"));
        assertThat(left.keyframes())
                .isEqualTo(ShippedMotions.motion("kick-right").mirrored().keyframes());
        assertThat(left.property("ball"))
                .isEqualTo(ShippedMotions.file("kick-left").property("ball"));
        assertThat(left.property("does")).contains("kicks the ball hard with the left foot");
    }

    @Test
    void refusesTheOtherSideOfAMotionWithoutSides() {
        assertThatThrownBy(() -> OtherSide.of(Path.of("bow.txt")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("--both-sides needs an output file whose name contains left or right, not bow.txt.");
    }

    private static MotionParametrization subject(String name, Objective objective) {
        return new MotionParametrization(name, ShippedMotions.file(name), objective);
    }
}
