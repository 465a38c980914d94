package org.robonewbie.workshop.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

class BenchmarkTest {

    @Test
    void everyNumberOfRobotsIsMeasuredInEveryScene() throws IOException {
        BenchmarkPlan plan = plan(List.of(1, 3), List.of(CrowdScene.WALKING, CrowdScene.HEAP), Optional.empty());
        List<BenchmarkRun> progress = new ArrayList<>();

        BenchmarkReport report = new Benchmark(plan).run(progress::add, sample -> {});

        assertThat(report.runs()).isEqualTo(progress);
        assertThat(report.runs()).extracting(BenchmarkRun::robots).containsExactly(1, 3, 1, 3);
        assertThat(report.runs())
                .extracting(BenchmarkRun::scene)
                .containsExactly(CrowdScene.WALKING, CrowdScene.WALKING, CrowdScene.HEAP, CrowdScene.HEAP);
        assertThat(report.runs()).allSatisfy(run -> {
            assertThat(run.cycles()).isEqualTo(10);
            assertThat(run.realTimeFactor()).isPositive();
            assertThat(run.cpuMillisPerCycle().orElseThrow()).isPositive();
            assertThat(run.allocatedBytesPerCycle().orElseThrow()).isPositive();
            assertThat(run.peakMemoryBytes()).isPositive();
        });
    }

    @Test
    void resultsAreWrittenAsJson() throws IOException {
        BenchmarkPlan plan = plan(List.of(1), List.of(CrowdScene.STANDING), Optional.empty());

        String json = new Benchmark(plan).run(run -> {}, sample -> {}).toJson();

        JsonObject run = JsonParser.parseString(json)
                .getAsJsonObject()
                .getAsJsonArray("runs")
                .get(0)
                .getAsJsonObject();
        assertThat(run.keySet())
                .containsExactly(
                        "robots",
                        "scene",
                        "threads",
                        "realTimeFactor",
                        "cpuMillisPerCycle",
                        "allocatedBytesPerCycle",
                        "cycles",
                        "peakMemoryBytes",
                        "heap");
        assertThat(run.get("robots").getAsInt()).isEqualTo(1);
        assertThat(run.get("scene").getAsString()).isEqualTo("standing");
        assertThat(run.get("threads").getAsInt()).isEqualTo(1);
    }

    @Test
    void robotsThinkOnSeveralThreads() throws IOException {
        BenchmarkPlan plan = new BenchmarkPlan(
                List.of(5), List.of(CrowdScene.WALKING), 0.1, 0.5, OptionalDouble.empty(), 2, Optional.empty());

        BenchmarkRun run =
                new Benchmark(plan).run(ignored -> {}, ignored -> {}).runs().get(0);

        assertThat(run.threads()).isEqualTo(2);
        assertThat(run.cycles()).isEqualTo(25);
        assertThat(run.realTimeFactor()).isPositive();
    }

    @Test
    void memoryInUseIsLookedAtFromTimeToTime() throws IOException {
        BenchmarkPlan plan = new BenchmarkPlan(
                List.of(1), List.of(CrowdScene.WALKING), 0.1, 0.5, OptionalDouble.of(0.2), 1, Optional.empty());
        List<HeapSample> progress = new ArrayList<>();

        BenchmarkRun run =
                new Benchmark(plan).run(ignored -> {}, progress::add).runs().get(0);

        assertThat(run.heap()).isEqualTo(progress);
        assertThat(run.heap()).extracting(HeapSample::seconds).containsExactly(0.2, 0.4, 0.5);
        assertThat(run.heap()).allSatisfy(sample -> assertThat(sample.bytes()).isBetween(1_000_000L, 1_000_000_000L));
    }

    @Test
    void serverOfAnotherProcessIsMeasuredOverTcp() throws IOException {
        SimulatorSettings settings = SimulatorSettings.of(WorldSettings.league())
                .withAgentPort(0)
                .withMonitorPort(0)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE);
        try (Simulator simulator = Simulator.start(settings, Console.silent())) {
            ServerAddress address = new ServerAddress(
                    "127.0.0.1",
                    simulator.agentPort(),
                    simulator.monitorPort().orElseThrow(),
                    OptionalLong.of(ProcessHandle.current().pid()));

            BenchmarkReport report = new Benchmark(plan(List.of(2), List.of(CrowdScene.WALKING), Optional.of(address)))
                    .run(run -> {}, sample -> {});

            BenchmarkRun run = report.runs().get(0);
            assertThat(run.threads()).isZero();
            assertThat(run.realTimeFactor()).isPositive();
            assertThat(run.allocatedBytesPerCycle()).isEmpty();
            assertThat(BenchmarkReport.line(run)).contains("walking");
        }
    }

    @Test
    void robotsJoinAServerThatAdmitsOneAtATime() throws IOException {
        try (OneAtATimeServer server = new OneAtATimeServer(22, Integer.MAX_VALUE)) {
            BenchmarkPlan plan = plan(List.of(4), List.of(CrowdScene.WALKING), Optional.of(server.address()));

            BenchmarkReport report = new Benchmark(plan).run(run -> {}, sample -> {});

            assertThat(report.runs()).extracting(BenchmarkRun::robots).containsExactly(4);
            assertThat(report.runs().get(0).cycles()).isEqualTo(10);
        }
    }

    @Test
    void aServerThatAdmitsNoMoreRobotsIsTold() throws IOException {
        try (OneAtATimeServer server = new OneAtATimeServer(2, Integer.MAX_VALUE)) {
            BenchmarkPlan plan = plan(List.of(3), List.of(CrowdScene.WALKING), Optional.of(server.address()));

            assertThatThrownBy(() -> new Benchmark(plan).run(run -> {}, sample -> {}))
                    .isInstanceOf(IOException.class)
                    .hasMessage(
                            "Robot 3 of the benchmark could not join: it was not assigned to a team. Check that the server"
                                    + " has a free place and that no other robots are in its team.");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 30})
    void aStalledServerIsReported(int cycles) throws IOException {
        try (OneAtATimeServer server = new OneAtATimeServer(22, cycles)) {
            BenchmarkPlan plan = plan(List.of(4), List.of(CrowdScene.WALKING), Optional.of(server.address()));

            assertThatThrownBy(() -> new Benchmark(plan, Duration.ofSeconds(1)).run(run -> {}, sample -> {}))
                    .isInstanceOf(IOException.class)
                    .hasMessageStartingWith("The server has sent nothing for 1 s. Check that it runs in sync mode");
        }
    }

    private static BenchmarkPlan plan(List<Integer> robots, List<CrowdScene> scenes, Optional<ServerAddress> other) {
        return new BenchmarkPlan(robots, scenes, 0.1, 0.2, OptionalDouble.empty(), 1, other);
    }

    @Test
    void resultsAreWrittenAsTheTableOfTheDocumentation() {
        BenchmarkReport report = new BenchmarkReport(List.of(
                run(1, CrowdScene.STANDING, 0.084, 201.4),
                run(1, CrowdScene.WALKING, 0.091, 190),
                run(3, CrowdScene.WALKING, 0.2, 80)));

        assertThat(report.toMarkdown()).isEqualTo("""
                | robots | standing | walking | rcssserver3d 0.7.3, robots moving |
                |---|---|---|---|
                | 1 | 0.08 ms, 201 × | 0.09 ms, 190 × | 0.45 ms |
                | 3 | - | 0.20 ms, 80 × | - |
                """);
    }

    private static BenchmarkRun run(int robots, CrowdScene scene, double millis, double factor) {
        return new BenchmarkRun(
                robots, scene, 1, factor, OptionalDouble.of(millis), OptionalDouble.empty(), 500, 1, List.of());
    }
}
