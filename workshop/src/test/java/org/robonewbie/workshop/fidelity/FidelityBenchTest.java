package org.robonewbie.workshop.fidelity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Vector3;

class FidelityBenchTest {

    private static final String BALL = """
            {"header": {"test": "ball"}}
            {"case": "drop_h0.5", "ball": [0.0, 0.0, 0.496076], "t": 0.02}
            {"case": "drop_h0.5", "ball": [0.0, 0.0, 0.488258], "t": 0.04}
            """;

    private static final String FALL = "d_fall_front_nonoise.jsonl.gz";

    @TempDir
    @SuppressWarnings("NullAway.Init")
    private Path directory;

    @Test
    void replaysThePlainFilesOfADirectory() throws IOException {
        Files.writeString(directory.resolve("ball.jsonl"), BALL);
        Files.writeString(directory.resolve("notes.txt"), "not a recording");

        FidelityReport report = FidelityBench.run(directory, AgentRoute.NONE);

        assertThat(report.recordings()).singleElement().satisfies(result -> {
            assertThat(result.name()).isEqualTo("ball");
            assertThat(result.ballMaxMetres().orElseThrow()).isLessThan(1e-6);
            assertThat(result.firstDivergenceSeconds()).isEmpty();
        });
    }

    /** The monitor of a recorder may miss the full scene of any cycle, also of the first one. */
    @Test
    void replaysABallWithoutItsFirstPosition() throws IOException {
        Files.writeString(directory.resolve("ball.jsonl"), BALL.replaceFirst("\"ball\": *\\[[^]]*], *", ""));

        RecordingFidelity result =
                FidelityBench.run(directory, AgentRoute.NONE).recordings().get(0);

        assertThat(result.ballMaxMetres().orElseThrow()).isLessThan(1e-6);
        assertThat(result.firstDivergenceSeconds()).isEmpty();
    }

    @Test
    void compressedFilesGiveTheSameAsPlainOnes() throws IOException {
        Files.write(directory.resolve(FALL), shipped(FALL));
        Files.writeString(directory.resolve(FALL.replace(".gz", "")), plainFall());

        FidelityReport report = FidelityBench.run(directory, AgentRoute.NONE);

        assertThat(report.recordings()).hasSize(2);
        assertThat(report.recordings().get(0)).isEqualTo(report.recordings().get(1));
    }

    @Test
    void noticesABallThatMovesDifferently() throws IOException {
        Files.writeString(directory.resolve("ball.jsonl"), BALL.replace("0.488258", "0.489258"));

        RecordingFidelity result =
                FidelityBench.run(directory, AgentRoute.NONE).recordings().get(0);

        assertThat(result.ballMaxMetres().orElseThrow()).isBetween(0.0009, 0.0011);
        assertThat(result.restMetres().orElseThrow()).isBetween(0.0009, 0.0011);
        assertThat(result.firstDivergenceSeconds().orElseThrow()).isEqualTo(0.02);
    }

    @Test
    void noticesARobotThatIsToldSomethingElse() throws IOException {
        Files.writeString(directory.resolve("fall.jsonl"), plainFall().replace("(lle5 1.5)", "(lle5 1.4)"));

        RecordingFidelity result =
                FidelityBench.run(directory, AgentRoute.NONE).recordings().get(0);

        assertThat(result.jointMaxDegrees().orElseThrow()).isGreaterThan(0.1);
        assertThat(result.gyrRowsEqual().orElseThrow()).isLessThan(0.9);
        assertThat(result.firstDivergenceSeconds().orElseThrow()).isBetween(0.05, 0.2);
    }

    @Test
    void refusesAPathThatIsNoDirectory() {
        Path missing = directory.resolve("missing");

        assertThatThrownBy(() -> FidelityBench.run(missing, AgentRoute.NONE))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("missing is not a directory. Choose one that contains recordings");
    }

    @Test
    void refusesADirectoryWithoutRecordings() {
        assertThatThrownBy(() -> FidelityBench.run(directory, AgentRoute.NONE))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("contains no recordings (*.jsonl or *.jsonl.gz).");
    }

    @Test
    void namesFileAndLineOfARowThatCannotBeRead() throws IOException {
        Files.writeString(directory.resolve("broken.jsonl"), BALL + "{\"t\": \"soon\"}\n");

        assertThat(problem())
                .isEqualTo("broken.jsonl, line 4 is not a recording row:"
                        + " expected a JSON object with t and hj, torso or ball.");
    }

    @Test
    void namesARowWithSomethingElseThanExpected() throws IOException {
        Files.writeString(directory.resolve("broken.jsonl"), "{\"t\": 1, \"torso\": 3}\n");

        assertThat(problem()).startsWith("broken.jsonl, line 1 is not a recording row");
    }

    @Test
    void asksForANameThatTellsHowTheBallStarted() throws IOException {
        Files.writeString(directory.resolve("ball.jsonl"), BALL.replace("drop_h0.5", "spin"));

        assertThat(problem())
                .isEqualTo("Unknown ball case \"spin\". Expected a name such as roll_v3, drop_h0.5 or lob_4_4.");
    }

    @Test
    void asksForTorsoOrBall() throws IOException {
        Files.writeString(directory.resolve("empty.jsonl"), "{\"t\": 0.02, \"hj\": {\"hj1\": 0.0}}\n");

        assertThat(problem())
                .isEqualTo("The recording empty contains neither torso nor ball positions. It needs one of them.");
    }

    @Test
    void namesADamagedFileAndReplaysTheOthers() throws IOException {
        byte[] packed = shipped(FALL);
        Files.write(directory.resolve("a_torn.jsonl.gz"), Arrays.copyOf(packed, packed.length / 2));
        Files.writeString(directory.resolve("b_plain.jsonl.gz"), BALL);
        Files.writeString(directory.resolve("c_ball.jsonl"), BALL);

        FidelityReport report = FidelityBench.run(directory, AgentRoute.NONE);

        assertThat(report.recordings()).extracting(RecordingFidelity::name).containsExactly("c_ball");
        assertThat(report.problems())
                .hasSize(2)
                .allMatch(problem -> problem.endsWith("Copy or compress it again."))
                .satisfies(problems -> assertThat(problems.get(0)).startsWith("a_torn.jsonl.gz is damaged"));
        assertThat(report.toJson()).contains("\"problems\"", "b_plain.jsonl.gz is damaged");
    }

    @Test
    void whatIsMissingInARowIsNotCompared() throws IOException {
        String text = plainFall()
                .replaceAll("\"frp\": (\\{\\}|\\{.*?\\}\\}), ", "\"frp\": null, ")
                .replaceAll("\"gyr\": \\[.*?\\], ", "")
                .replaceAll(", \"sent\": \"\"", "");
        Files.writeString(directory.resolve("fall.jsonl"), text);

        RecordingFidelity result =
                FidelityBench.run(directory, AgentRoute.NONE).recordings().get(0);

        assertThat(result.frpRowsEqual()).isEmpty();
        assertThat(result.gyrRowsEqual()).isEmpty();
        assertThat(result.accRowsEqual()).hasValue(1);
        assertThat(result.firstDivergenceSeconds()).isEmpty();
    }

    @Test
    void lostLinesWithoutCommandsDoNotDisturb() throws IOException {
        List<String> lines = new ArrayList<>(plainFall().lines().toList());
        lines.removeAll(List.copyOf(lines.subList(100, 107)));
        Files.write(directory.resolve("fall.jsonl"), lines);

        RecordingFidelity result =
                FidelityBench.run(directory, AgentRoute.NONE).recordings().get(0);

        assertThat(result.firstDivergenceSeconds()).isEmpty();
    }

    @Test
    void aBallMayAlsoRollBackwardsOrBeLobbedAtAnySpeed() throws IOException {
        assertThat(BallStart.of("roll_v-2.5", 0.042).velocity()).isEqualTo(new Vector3(-2.5, 0, 0));
        assertThat(BallStart.of("lob_6_2.5_playon", 0.042).velocity()).isEqualTo(new Vector3(6, 0, 2.5));
        assertThat(BallStart.of("drop_h1.25", 0.042).position()).isEqualTo(new Vector3(0, 0, 1.25));
    }

    private String problem() throws IOException {
        FidelityReport report = FidelityBench.run(directory, AgentRoute.NONE);
        assertThat(report.recordings()).isEmpty();
        assertThat(report.problems()).hasSize(1);
        return report.problems().get(0);
    }

    private static byte[] shipped(String name) throws IOException {
        try (InputStream stream =
                Objects.requireNonNull(FidelityBench.class.getResourceAsStream("recordings/" + name))) {
            return stream.readAllBytes();
        }
    }

    private static String plainFall() throws IOException {
        try (InputStream plain = new GZIPInputStream(new ByteArrayInputStream(shipped(FALL)))) {
            return new String(plain.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
