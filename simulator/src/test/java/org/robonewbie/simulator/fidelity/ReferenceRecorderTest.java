package org.robonewbie.simulator.fidelity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.server.Console;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.PhysicsEngine;

/** Records our own server over both ports, as one would record rcssserver3d, and replays what was recorded. */
@Timeout(300)
class ReferenceRecorderTest {

    @TempDir
    @SuppressWarnings("NullAway.Init")
    private Path directory;

    private final ByteArrayOutputStream progress = new ByteArrayOutputStream();

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4})
    void whatIsRecordedIsReplayedToThePrintedDigitWithEveryBuild(int type) throws IOException {
        List<ReferenceScenario> scenarios = ReferenceScenario.all().stream()
                .filter(scenario -> List.of("d_fall_front", "h_squat").contains(scenario.name()))
                .toList();
        try (Simulator simulator = start(true)) {
            recorder(simulator, type).record(scenarios, directory);
        }

        FidelityReport report = FidelityBench.run(directory, AgentRoute.NONE, PhysicsEngine.STANDARD);

        assertThat(report.problems()).isEmpty();
        assertThat(report.recordings()).hasSize(2).allSatisfy(result -> {
            assertThat(result.jointMaxDegrees().orElseThrow()).isLessThan(0.0055);
            assertThat(result.torsoMaxMetres().orElseThrow()).isLessThan(2e-5);
            assertThat(result.accRowsEqual().orElseThrow()).isGreaterThan(0.99);
            assertThat(result.frpRowsEqual().orElseThrow()).isGreaterThan(0.99);
            assertThat(result.firstDivergenceSeconds()).isEmpty();
        });
    }

    @Test
    void buildsAreToldApartEvenIfTheHeaderDoesNotNameThem() throws IOException {
        ReferenceScenario fall = ReferenceScenario.all().stream()
                .filter(scenario -> scenario.name().equals("d_fall_front"))
                .findFirst()
                .orElseThrow();
        try (Simulator simulator = start(true)) {
            recorder(simulator, 3).record(List.of(fall), directory);
        }
        Recording recorded = FidelityBench.read(directory.resolve("d_fall_front.jsonl.gz"));

        RecordingFidelity result =
                Replay.of(new Recording("unnamed", "", recorded.runs()), AgentRoute.NONE, PhysicsEngine.STANDARD);

        assertThat(result.firstDivergenceSeconds()).isEmpty();
        assertThat(result.torsoMaxMetres().orElseThrow()).isLessThan(2e-5);
    }

    @Test
    void theCommandsOfAnyRecordingCanBeRepeated() throws IOException {
        Recording shipped = FidelityBench.readShipped("d_fall_side_nonoise.jsonl.gz");
        try (Simulator simulator = start(true)) {
            recorder(simulator, 0).record(List.of(ReferenceScenario.of(shipped)), directory);
        }

        Recording repeated = FidelityBench.read(directory.resolve("d_fall_side_nonoise.jsonl.gz"));

        List<RecordedRow> rows = repeated.runs().get(0).rows();
        List<RecordedRow> original = shipped.runs().get(0).rows();
        assertThat(rows)
                .extracting(RecordedRow::sent)
                .containsAll(original.stream().map(RecordedRow::sent).toList());
        assertThat(rows.get(150).gyro()).isEqualTo(original.get(150).gyro());
        assertThat(progress.toString(StandardCharsets.UTF_8)).contains("recording 1 of 1: d_fall_side_nonoise");
    }

    @Test
    void aServerThatDoesNotWaitIsRefusedWithAdvice() throws IOException {
        try (Simulator simulator = start(false)) {
            ReferenceRecorder recorder = recorder(simulator, 0);

            assertThatThrownBy(() -> recorder.record(ReferenceScenario.all().subList(0, 1), directory))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("The server has not waited for the agent. Let it run in sync mode");
        }
    }

    private ReferenceRecorder recorder(Simulator simulator, int type) {
        ReferenceServer server = new ReferenceServer(
                "127.0.0.1", simulator.agentPort(), simulator.monitorPort().orElseThrow());
        return new ReferenceRecorder(server, type, new PrintStream(progress, true, StandardCharsets.UTF_8));
    }

    private static Simulator start(boolean synchronous) throws IOException {
        return Simulator.start(
                SimulatorSettings.league()
                        .parameters(
                                SoccerParameters.league().with("BeamNoiseXY=0").with("BeamNoiseAngle=0"))
                        .noise(false)
                        .agentPort(0)
                        .monitorPort(OptionalInt.of(0))
                        .monitorStepSeconds(0.02)
                        .synchronous(synchronous)
                        .speed(synchronous ? SimulationControl.AS_FAST_AS_POSSIBLE : 1)
                        .build(),
                Console.silent());
    }
}
