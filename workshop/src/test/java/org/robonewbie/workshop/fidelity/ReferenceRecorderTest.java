package org.robonewbie.workshop.fidelity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Records our own server over both ports, as one would record rcssserver3d, and replays what was recorded. */
@Tag("slow")
@Timeout(300)
class ReferenceRecorderTest {

    @TempDir
    @SuppressWarnings("NullAway.Init")
    private Path directory;

    private final ByteArrayOutputStream progress = new ByteArrayOutputStream();

    @Test
    void whatIsRecordedIsReplayedToThePrintedDigit() throws IOException {
        checkReplayOf(0);
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void whatIsRecordedIsReplayedToThePrintedDigitWithEveryBuild(int type) throws IOException {
        checkReplayOf(type);
    }

    private void checkReplayOf(int type) throws IOException {
        List<ReferenceScenario> scenarios = List.of(scenario("h_squat"), scenario("d_fall_side"));
        try (Simulator simulator = start(true)) {
            recorder(simulator, type).record(scenarios, directory);
        }

        FidelityReport report = FidelityBench.run(directory, AgentRoute.NONE);

        assertThat(report.problems()).isEmpty();
        assertThat(report.recordings()).hasSize(2).allSatisfy(result -> {
            assertThat(result.jointMaxDegrees().orElseThrow()).isLessThan(0.0055);
            assertThat(result.torsoMaxMetres().orElseThrow()).isLessThan(1e-5);
            assertThat(result.accRowsEqual().orElseThrow()).isGreaterThan(0.99);
            assertThat(result.gyrRowsEqual().orElseThrow()).isGreaterThan(0.99);
            assertThat(result.frpRowsEqual().orElseThrow()).isGreaterThan(0.99);
            assertThat(result.firstDivergenceSeconds()).isEmpty();
        });
    }

    @Test
    void ballsAreRecordedToo() throws IOException {
        List<BallCase> cases = List.of(new BallCase("roll_v3", 60), new BallCase("lob_4_4", 60));
        ReferenceScenario balls = new ReferenceScenario("f_ball", "two balls", List.of(), cases);
        try (Simulator simulator = start(true)) {
            recorder(simulator, 0).record(List.of(balls), directory);
        }

        Recording recorded = FidelityBench.read(directory.resolve("f_ball.jsonl.gz"));
        RecordingFidelity result = Replay.of(recorded, AgentRoute.NONE);

        assertThat(recorded.runs()).extracting(RecordedRun::name).containsExactly("roll_v3", "lob_4_4");
        assertThat(recorded.runs()).allSatisfy(run -> assertThat(run.rows()).hasSize(60));
        assertThat(result.ballMaxMetres().orElseThrow()).isLessThan(1e-5);
    }

    @Tag("slow")
    @Test
    void aRobotOnANoisyServerIsFollowedFromWhereItStands() throws IOException {
        ReferenceScenario squat = scenario("h_squat");
        try (Simulator simulator = start(exactServer().withParameters(SoccerParameters.league()), 0.02)) {
            recorder(simulator, 0).record(List.of(squat), directory);
        }

        RecordingFidelity result =
                FidelityBench.run(directory, AgentRoute.NONE).recordings().get(0);

        assertThat(result.torsoMaxMetres().orElseThrow()).isLessThan(2e-5);
        assertThat(result.restMetres().orElseThrow()).isLessThan(2e-5);
        assertThat(progress.toString(StandardCharsets.UTF_8))
                .contains("  the server adds noise to beams; set BeamNoiseXY and BeamNoiseAngle to 0");
    }

    @Test
    void aServerThatTellsMonitorsNothingIsRefusedWithAdvice() throws IOException {
        try (Simulator simulator = start(true);
                ServerSocket mute = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            ReferenceRecorder recorder = new ReferenceRecorder(
                    new ReferenceServer("127.0.0.1", simulator.agentPort(), mute.getLocalPort()), 0, System.out);

            assertThatThrownBy(() -> recorder.record(ReferenceScenario.all().subList(0, 1), directory))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("The server does not send a monitor message in each cycle. Set $monitorStep"
                            + " = 0.02 in spark.rb, or start robonewbie simulator with --monitor-step 0.02.");
        }
    }

    @Test
    void buildsAreToldApartEvenIfTheHeaderDoesNotNameThem() throws IOException {
        ReferenceScenario fall = scenario("d_fall_front");
        try (Simulator simulator = start(true)) {
            recorder(simulator, 3).record(List.of(fall), directory);
        }
        Recording recorded = FidelityBench.read(directory.resolve("d_fall_front.jsonl.gz"));

        RecordingFidelity result = Replay.of(new Recording("unnamed", "", recorded.runs()), AgentRoute.NONE);

        assertThat(result.firstDivergenceSeconds()).isEmpty();
        assertThat(result.torsoMaxMetres().orElseThrow()).isLessThan(2e-5);
    }

    @Tag("slow")
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

    @Tag("slow")
    @Test
    void aServerThatDoesNotWaitIsRefusedWithAdvice() throws IOException {
        try (Simulator simulator = start(false)) {
            ReferenceRecorder recorder = recorder(simulator, 0);

            assertThatThrownBy(() -> recorder.record(ReferenceScenario.all().subList(0, 1), directory))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("The server did not wait for the agent. Run it in sync mode");
        }
    }

    private static ReferenceScenario scenario(String name) {
        return ReferenceScenario.all().stream()
                .filter(scenario -> scenario.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private ReferenceRecorder recorder(Simulator simulator, int type) {
        ReferenceServer server = new ReferenceServer(
                "127.0.0.1", simulator.agentPort(), simulator.monitorPort().orElseThrow());
        return new ReferenceRecorder(server, type, new PrintStream(progress, true, StandardCharsets.UTF_8));
    }

    private static Simulator start(boolean synchronous) throws IOException {
        return start(exactServer().withSynchronous(synchronous), 0.02);
    }

    private static Simulator start(WorldSettings world, double monitorStepSeconds) throws IOException {
        SimulatorSettings settings = SimulatorSettings.of(world)
                .withAgentPort(0)
                .withMonitors(
                        new SimulatorSettings.Monitors(OptionalInt.of(0), monitorStepSeconds, true, Optional.empty()))
                .withSpeed(world.synchronous() ? SimulationControl.AS_FAST_AS_POSSIBLE : 1);
        return Simulator.start(settings, Console.silent());
    }

    private static WorldSettings exactServer() {
        return WorldSettings.league()
                .withParameters(SoccerParameters.league().with("BeamNoiseXY=0").with("BeamNoiseAngle=0"))
                .withNoise(false);
    }
}
