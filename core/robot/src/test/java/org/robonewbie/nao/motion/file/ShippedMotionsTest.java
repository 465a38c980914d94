package org.robonewbie.nao.motion.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.MotionFile;

class ShippedMotionsTest {

    private static final Path FOLDER = Path.of("src/main/resources/motions");

    @Test
    void indexNamesEachFileOfTheFolder() {
        assertThat(new ShippedMotions().names())
                .as("the lines of motions/index, which has to be changed with the files beside it")
                .isEqualTo(new MotionFiles(FOLDER).names());
    }

    @Test
    void eachShippedMotionCanBePlayedWithoutAWarning() {
        assertThat(new ShippedMotions().names())
                .allSatisfy(
                        name -> assertThat(ShippedMotions.file(name).warnings()).isEmpty())
                .map(name -> ShippedMotions.motion(name).name())
                .containsExactlyElementsOf(new ShippedMotions().names());
    }

    @Test
    void eachShippedMotionNamesItsColumns() {
        String columns = Stream.concat(
                        Stream.of("milliseconds"), Arrays.stream(Joint.values()).map(Joint::name))
                .collect(Collectors.joining(", "));

        assertThat(new ShippedMotions().names())
                .map(ShippedMotions::file)
                .allSatisfy(file -> assertThat(file.property("columns")).contains(columns));
    }

    @Test
    void namesAMotionThatIsMissing() {
        assertThatThrownBy(() -> ShippedMotions.motion("fly"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("There is no shipped motion \"fly\".");
    }

    @Test
    void libraryFindsTheMirrorImageOfAMotion() throws Exception {
        MotionFile right =
                MotionFiles.library().find("stand-up-from-right-side").orElseThrow();
        MotionFile left = right.mirrored("stand-up-from-left-side");

        assertThat(left.motion().mirrored().keyframes())
                .isEqualTo(right.motion().keyframes());
    }
}
