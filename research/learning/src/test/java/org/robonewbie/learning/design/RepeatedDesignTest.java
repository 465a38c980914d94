package org.robonewbie.learning.design;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** The shipped files come out again, byte for byte; of those that are quickly made. */
class RepeatedDesignTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        "turn-left, turn-right",
        "turn-left-small, turn-right-small",
        "side-step-left, side-step-right",
        "dance, dance",
        "stand-up-from-left-side, stand-up-from-right-side"
    })
    void isThatOfTheLibrary(String name, String otherSide) throws IOException {
        MotionWorkshop.make(name, folder);

        assertThat(made(name)).isEqualTo(shipped(name));
        assertThat(made(otherSide)).isEqualTo(shipped(otherSide));
    }

    private String made(String name) throws IOException {
        return MotionFiles.load(folder.resolve(name + ".txt")).text();
    }

    /** What was measured is added afterwards. */
    private static String shipped(String name) {
        return ShippedMotions.file(name).text().replaceFirst("(?m)^// measured:.*\\R", "");
    }
}
