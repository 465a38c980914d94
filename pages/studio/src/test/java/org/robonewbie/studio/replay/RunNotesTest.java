package org.robonewbie.studio.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.telemetry.Drawing;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.file.RecordingRepository;

class RunNotesTest {

    @TempDir
    private Path folder;

    private Path recording() throws IOException {
        return Files.writeString(folder.resolve("today.rec.part"), "it grows");
    }

    private RunNotes notes() {
        return new RunNotes(Optional.of(new RecordingRepository(folder, 1_000_000)));
    }

    private static String notesOf(Path recording) throws IOException {
        return new String(RunNotes.read(recording, 0), StandardCharsets.UTF_8);
    }

    private static TelemetryMessage said(String level, String text) {
        return new TelemetryMessage("Blue", 4, 1.5, new TelemetryItem.LogEntry(level, text));
    }

    @Test
    void linesOfLogsAreKeptBesideTheRecordingThatGrows() throws IOException {
        Path recording = recording();
        RunNotes notes = notes();

        notes.keep(said("WARNING", "two\nlines"));
        notes.keep(said("DEBUG", "nothing"));
        notes.keep(new TelemetryMessage("Blue", 4, 1.5, new TelemetryItem.PlotValue("courage", 7)));
        notes.keep(said("INFO", "more"));

        assertThat(folder.resolve("today.notes")).exists();
        assertThat(notesOf(recording).lines())
                .containsExactly(
                        "{\"seconds\":1.5,\"robot\":\"Blue 4\",\"level\":\"WARNING\",\"text\":\"two\\nlines\"}",
                        "{\"seconds\":1.5,\"robot\":\"Blue 4\",\"level\":\"INFO\",\"text\":\"more\"}");
        assertThat(notesOf(folder.resolve("today.rec")))
                .as("when the run has ended")
                .hasLineCount(2);
    }

    @Test
    void runKeepsTwoThousandLinesAtMost() throws IOException {
        Path recording = recording();
        RunNotes notes = notes();

        for (int i = 0; i < 2100; i++) {
            notes.keep(said("INFO", "line " + i));
        }

        assertThat(notesOf(recording)).hasLineCount(2000).contains("line 1999");
    }

    @Test
    void tenPicturesOfEachRobotPerSecondAreKeptUpToAnAmount() throws IOException {
        Path recording = recording();
        RunNotes notes = notes();

        for (int cycle = 0; cycle < 50; cycle++) {
            notes.keep(drawn(4, cycle, "here"));
            notes.keep(drawn(5, cycle, "there"));
        }

        assertThat(notesOf(recording))
                .hasLineCount(20)
                .startsWith("{\"drawn\":\"draw\\t0.0\\tBlue\\t4\\ttext\\tred\\t0.0\\t0.0\\t0.0\\there\"}");
        for (int cycle = 50; cycle < 1050; cycle += 5) {
            notes.keep(drawn(4, cycle, "x".repeat(50_000)));
        }
        assertThat(notesOf(recording).length()).isBetween(3_900_000, 4_001_000);
    }

    private static TelemetryMessage drawn(int number, int cycle, String text) {
        return new TelemetryMessage(
                "Blue",
                number,
                cycle / 50.0,
                new TelemetryItem.Picture(List.of(new Drawing.Text(Vector3.ZERO, text, "red"))));
    }

    @Test
    void notesOfRecordingsThatHaveGoneAreRemoved() throws IOException {
        recording();
        Files.writeString(folder.resolve("old.rec"), "still there");
        Path kept = Files.writeString(folder.resolve("old.notes"), "{}\n");
        Path orphan = Files.writeString(folder.resolve("older.notes"), "{}\n");

        notes().keep(said("INFO", "hello"));

        assertThat(kept).exists();
        assertThat(orphan).doesNotExist();
    }

    @Test
    void nothingIsKeptWithoutARecording() throws IOException {
        notes().keep(said("INFO", "hello"));
        new RunNotes(Optional.empty()).keep(said("INFO", "hello"));

        assertThat(folder).isEmptyDirectory();
        assertThat(notesOf(folder.resolve("none.rec"))).isEmpty();
    }
}
