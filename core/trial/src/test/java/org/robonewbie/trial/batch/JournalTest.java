package org.robonewbie.trial.batch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.file.UnwritableFileException;

class JournalTest {

    private static final String HEADER = "steps of seeds 1 to 9";

    @TempDir
    private Path folder;

    private Path file = Path.of("");

    @BeforeEach
    void nameTheFile() {
        file = folder.resolve("steps.journal");
    }

    private Journal open() throws IOException {
        return Journal.open(file, HEADER);
    }

    @Test
    void linesAreInTheFileAtOnce() throws IOException {
        try (Journal journal = open()) {
            journal.add("1,20");
            journal.add("2,ü");

            assertThat(Files.readAllLines(file)).containsExactly(HEADER, "1,20", "2,ü");
            assertThat(journal.lines()).isEmpty();
        }
    }

    @Test
    void resumesAfterItsLines() throws IOException {
        try (Journal journal = open()) {
            journal.add("1,20");
        }

        try (Journal again = open()) {
            assertThat(again.lines()).containsExactly("1,20");
            again.add("2,21");
        }

        assertThat(Files.readAllLines(file)).containsExactly(HEADER, "1,20", "2,21");
    }

    @Test
    void dropsALineThatWasNotCompletelyWritten() throws IOException {
        Files.writeString(file, HEADER + "\n1,20\n2,2");

        try (Journal again = open()) {
            assertThat(again.lines()).containsExactly("1,20");
            again.add("2,21");
        }

        assertThat(Files.readAllLines(file)).containsExactly(HEADER, "1,20", "2,21");
    }

    @Test
    void fileWithoutHeaderIsResumedToo() throws IOException {
        Files.writeString(file, "1,20\n2,2");

        try (Journal again = Journal.open(file, "")) {
            assertThat(again.lines()).containsExactly("1,20");
            again.add("2,21");
        }

        assertThat(Files.readAllLines(file)).containsExactly("1,20", "2,21");
    }

    @Test
    void headerThatWasNotCompletelyWrittenIsWrittenAgain() throws IOException {
        Files.writeString(file, "steps of");

        open().close();

        assertThat(file).hasContent(HEADER);
    }

    @Test
    void refusesAnotherRunAndKeepsItsFile() throws IOException {
        List<String> lines = List.of("steps of seeds 1 to 8", "1,20");
        Files.write(file, lines);

        assertThatThrownBy(this::open)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(file + " belongs to another run:\n  steps of seeds 1 to 8\nand not to:\n  " + HEADER
                        + "\nUse the same options as before, or delete the file to start over.");
        assertThat(Files.readAllLines(file)).isEqualTo(lines);
    }

    @Test
    void saysThatItsFileCannotBeWritten() throws IOException {
        Files.createDirectories(file);

        assertThatThrownBy(this::open)
                .isInstanceOf(UnwritableFileException.class)
                .hasMessageContaining("steps.journal cannot be written");
        assertThatThrownBy(() -> Journal.open(folder.resolve("none/steps.journal"), HEADER))
                .isInstanceOf(UnwritableFileException.class)
                .hasMessageContaining("its folder does not exist");
    }

    @Test
    void deletesItsFileAtTheEnd() throws IOException {
        Journal journal = open();
        Files.writeString(file, "1,20\n", StandardOpenOption.APPEND);

        journal.delete();

        assertThat(file).doesNotExist();
    }
}
