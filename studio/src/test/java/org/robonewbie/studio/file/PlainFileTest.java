package org.robonewbie.studio.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlainFileTest {

    @TempDir
    private Path place;

    @ParameterizedTest
    @ValueSource(
            strings = {"CON", "con", "NUL.x", "LPT1", "COM0", "COM\u00b9", "lpt\u00b3.rec", "aux .x", "goal.", "goal "})
    void refusesWhatWindowsCannotHave(String name) {
        assertThat(PlainFile.isName(name)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"goal", "console", "CON-1", "LPT", "COM10", "my.con", "first try 2", "null"})
    void takesAllOthers(String name) {
        assertThat(PlainFile.isName(name)).isTrue();
    }

    @Test
    void knowsFilesThatAreLinksToOtherPlaces() throws IOException {
        Path folder = Files.createDirectory(place.resolve("folder"));
        Path secret = Files.writeString(place.resolve("secret"), "hush");
        Path file = Files.writeString(folder.resolve("file"), "text");

        assertThat(PlainFile.isInItsFolder(file)).isTrue();
        assertThat(PlainFile.isInItsFolder(folder.resolve("none"))).isFalse();
        assertThat(PlainFile.isInItsFolder(Files.createSymbolicLink(folder.resolve("out"), secret)))
                .isFalse();
        assertThat(PlainFile.isInItsFolder(Files.createSymbolicLink(folder.resolve("in"), file)))
                .isTrue();
        assertThat(PlainFile.isInItsFolder(
                        Files.createSymbolicLink(place.resolve("way"), folder).resolve("file")))
                .isTrue();
    }
}
