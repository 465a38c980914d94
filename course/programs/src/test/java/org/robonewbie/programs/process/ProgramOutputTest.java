package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProgramOutputTest {

    private final List<String> lines = new ArrayList<>();
    private final List<String> answers = new ArrayList<>();
    private final ProgramOutput output = ProgramOutput.of(lines::add, answers::add);

    @Test
    void answersAreSeparatedFromLines() {
        read(output, "first\r\nbroken off\u0001ready\nlast");

        assertThat(lines).containsExactly("first", "broken off", "last");
        assertThat(answers).containsExactly("ready", "");
        assertThat(output.end()).isEqualTo("first\nbroken off\nlast\n");
    }

    @Test
    void longLinesAreSplit() {
        read(output, "x".repeat(2500) + "\n");

        assertThat(lines).extracting(String::length).containsExactly(1000, 1000, 500);
    }

    @Test
    void onlyTheEndIsKept() {
        read(output, "0123456789\n".repeat(1000));

        assertThat(output.end()).hasSize(4000).endsWith("789\n0123456789\n");
    }

    @Test
    void lackOfMemoryIsRecognised() {
        read(output, "Terminating due to java.lang.OutOfMemoryError: Java heap space\n");

        assertThat(output.isOutOfMemory()).isTrue();
    }

    @Test
    void fileIsLimited(@TempDir Path folder) {
        Path file = folder.resolve("log.txt");

        read(ProgramOutput.into(file), "y".repeat(3_000_000));

        assertThat(file.toFile().length()).isBetween(1_000_000L, 1_010_000L);
    }

    @Test
    void outputWithoutAFileIsDiscarded(@TempDir Path folder) {
        ProgramOutput lost = ProgramOutput.into(folder.resolve("missing/log.txt"));

        read(lost, "hello\n");

        assertThat(lost.end()).isEqualTo("hello\n");
    }

    private static void read(ProgramOutput output, String text) {
        output.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
        output.await();
    }
}
