package org.robonewbie.studio.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PlainFileTest {

    @TempDir
    private Path place;

    @Test
    void detectsLinksOutOfTheFolder() throws IOException {
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
