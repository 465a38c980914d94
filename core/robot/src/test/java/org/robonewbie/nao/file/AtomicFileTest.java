package org.robonewbie.nao.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
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
        assertThat(folder.toFile().list()).containsExactly("report.json");
    }

    @Test
    void leavesWhatWasThereIfTheNewFileCannotTakeItsName() throws IOException {
        Path file = folder.resolve("report.json");
        Files.createDirectories(file.resolve("full"));

        assertThatThrownBy(() -> AtomicFile.write(file, "after"))
                .isInstanceOf(UnwritableFileException.class)
                .hasMessageStartingWith("The file " + file + " cannot be written: ");

        assertThat(file.resolve("full")).isDirectory();
        assertThat(folder.toFile().list()).containsExactly("report.json");
    }

    @Test
    void missingFolderIsNamed() {
        Path file = folder.resolve("missing/report.json");

        assertThatThrownBy(() -> AtomicFile.write(file, "text"))
                .hasMessageStartingWith("The file " + file + " cannot be written: its folder does not exist");
    }

    @Test
    void writersOfTheSameFileDoNotTakeEachOthersParts() throws Exception {
        Path file = folder.resolve("table.csv");
        ExecutorService threads = Executors.newFixedThreadPool(8);
        List<Future<?>> writers = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            String text = String.valueOf(i).repeat(10_000);
            writers.add(threads.submit(() -> {
                for (int round = 0; round < 50; round++) {
                    AtomicFile.write(file, text);
                }
                return text;
            }));
        }
        for (Future<?> writer : writers) {
            writer.get();
        }
        threads.shutdown();

        assertThat(Files.readString(file)).matches("(\\d)\\1{9999}");
        assertThat(folder.toFile().list()).containsExactly("table.csv");
    }

    @Test
    void secondWriterOfAGrowingFileIsRefusedAndTheFirstGoesOn() throws IOException {
        Path file = folder.resolve("run.rec");

        try (OutputStream first = AtomicFile.begin(file)) {
            first.write("first".getBytes(StandardCharsets.UTF_8));
            assertThatThrownBy(() -> AtomicFile.begin(file))
                    .hasMessage(
                            "The file " + file + " is being written by another program. Wait until it finishes, or name"
                                    + " another file.");
            first.write("!".getBytes(StandardCharsets.UTF_8));
        }
        AtomicFile.moveIntoPlace(file);

        assertThat(file).hasContent("first!");
    }

    @Test
    void leftoverOfAKilledProgramIsOverwritten() throws IOException {
        Path file = folder.resolve("run.rec");
        Files.writeString(AtomicFile.part(file), "much that was left behind");

        try (OutputStream out = AtomicFile.begin(file)) {
            out.write('x');
        }

        assertThat(AtomicFile.part(file)).hasContent("x");
    }

    @Test
    void fullDiskIsToldWithTheFile() throws IOException {
        Path full = Path.of("/dev/full");
        assumeTrue(Files.exists(full), "no device here that is always full");
        Path file = folder.resolve("run.csv");
        Files.createSymbolicLink(AtomicFile.part(file), full);

        try (OutputStream out = AtomicFile.begin(file)) {
            assertThatThrownBy(() -> out.write(1))
                    .hasMessage("The file " + file
                            + " cannot be written: the disk is full (No space left on device). Free up some space and start"
                            + " again.");
        }
    }
}
