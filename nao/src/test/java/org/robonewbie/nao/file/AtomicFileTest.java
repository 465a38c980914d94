package org.robonewbie.nao.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {

    @TempDir
    Path folder;

    @Test
    void replacesTheFileAsAWhole() throws IOException {
        Path file = Files.writeString(folder.resolve("report.json"), "a longer text from before");

        AtomicFile.write(file, "größer");

        assertThat(file).hasContent("größer");
        assertThat(AtomicFile.part(file)).doesNotExist();
    }

    @Test
    void leavesTheFormerFileIfTheNewOneCannotBeWritten() throws IOException {
        Path file = Files.writeString(folder.resolve("report.json"), "before");
        Files.createDirectory(AtomicFile.part(file));

        assertThatIOException().isThrownBy(() -> AtomicFile.write(file, "after"));

        assertThat(file).hasContent("before");
    }
}
