package org.robonewbie.simulator.fidelity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FidelityBenchTest {

    private static final String BALL = """
            {"header": {"test": "ball"}}
            {"case": "drop_h0.5", "ball": [0.0, 0.0, 0.496076], "t": 0.02}
            {"case": "drop_h0.5", "ball": [0.0, 0.0, 0.488258], "t": 0.04}
            """;

    @TempDir
    @SuppressWarnings("NullAway.Init")
    private Path directory;

    @Test
    void replaysThePlainFilesOfADirectory() throws IOException {
        Files.writeString(directory.resolve("ball.jsonl"), BALL);
        Files.writeString(directory.resolve("notes.txt"), "not a recording");

        FidelityReport report = FidelityBench.run(directory);

        assertThat(report.recordings()).singleElement().satisfies(result -> {
            assertThat(result.name()).isEqualTo("ball");
            assertThat(result.ballMaxMetres().orElseThrow()).isLessThan(1e-6);
            assertThat(result.firstDivergenceSeconds()).isEmpty();
        });
    }

    @Test
    void compressedFilesGiveTheSameAsPlainOnes() throws IOException {
        String name = "d_fall_front_nonoise.jsonl.gz";
        try (InputStream shipped =
                Objects.requireNonNull(FidelityBench.class.getResourceAsStream("recordings/" + name))) {
            byte[] packed = shipped.readAllBytes();
            Files.write(directory.resolve(name), packed);
            try (InputStream plain = new GZIPInputStream(new ByteArrayInputStream(packed))) {
                Files.write(directory.resolve("d_fall_front_nonoise.jsonl"), plain.readAllBytes());
            }
        }

        FidelityReport report = FidelityBench.run(directory);

        assertThat(report.recordings()).hasSize(2);
        assertThat(report.recordings().get(0)).isEqualTo(report.recordings().get(1));
    }

    @Test
    void noticesABallThatMovesDifferently() throws IOException {
        Files.writeString(directory.resolve("ball.jsonl"), BALL.replace("0.488258", "0.489258"));

        RecordingFidelity result = FidelityBench.run(directory).recordings().get(0);

        assertThat(result.ballMaxMetres().orElseThrow()).isBetween(0.0009, 0.0011);
        assertThat(result.restMetres().orElseThrow()).isBetween(0.0009, 0.0011);
        assertThat(result.firstDivergenceSeconds().orElseThrow()).isEqualTo(0.02);
    }

    @Test
    void noticesARobotThatIsToldSomethingElse() throws IOException {
        String name = "d_fall_front_nonoise.jsonl.gz";
        try (InputStream shipped =
                        Objects.requireNonNull(FidelityBench.class.getResourceAsStream("recordings/" + name));
                InputStream plain = new GZIPInputStream(shipped)) {
            String text = new String(plain.readAllBytes(), StandardCharsets.UTF_8);
            Files.writeString(directory.resolve("fall.jsonl"), text.replace("(lle5 1.5)", "(lle5 1.4)"));
        }

        RecordingFidelity result = FidelityBench.run(directory).recordings().get(0);

        assertThat(result.jointMaxDegrees().orElseThrow()).isGreaterThan(0.1);
        assertThat(result.gyrRowsEqual().orElseThrow()).isLessThan(0.9);
        assertThat(result.firstDivergenceSeconds().orElseThrow()).isBetween(0.05, 0.2);
    }

    @Test
    void refusesAPathThatIsNoDirectory() {
        Path missing = directory.resolve("missing");

        assertThatThrownBy(() -> FidelityBench.run(missing))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("missing is not a directory. Name one that holds recordings");
    }

    @Test
    void refusesADirectoryWithoutRecordings() {
        assertThatThrownBy(() -> FidelityBench.run(directory))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("holds no recordings. Put files there whose names end with .jsonl or .jsonl.gz.");
    }

    @Test
    void namesFileAndLineOfARowThatCannotBeRead() throws IOException {
        Files.writeString(directory.resolve("broken.jsonl"), BALL + "{\"t\": \"soon\"}\n");

        assertThatThrownBy(() -> FidelityBench.run(directory))
                .isInstanceOf(IOException.class)
                .hasMessage("broken.jsonl, line 4 is not a row of a recording:"
                        + " expected a JSON object with t and hj, torso or ball.");
    }

    @Test
    void asksForANameThatTellsHowTheBallStarted() throws IOException {
        Files.writeString(directory.resolve("ball.jsonl"), BALL.replace("drop_h0.5", "spin"));

        assertThatThrownBy(() -> FidelityBench.run(directory))
                .isInstanceOf(IOException.class)
                .hasMessage("The ball case \"spin\" does not say how the ball started."
                        + " Name it like roll_v3, drop_h0.5 or lob_4_4.");
    }

    @Test
    void asksForTorsoOrBall() throws IOException {
        Files.writeString(directory.resolve("empty.jsonl"), "{\"t\": 0.02, \"hj\": {\"hj1\": 0.0}}\n");

        assertThatThrownBy(() -> FidelityBench.run(directory))
                .isInstanceOf(IOException.class)
                .hasMessage("The recording empty shows neither torso nor ball. It needs one of them.");
    }
}
