package org.robonewbie.workshop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.workshop.speed.Benchmark;
import org.robonewbie.workshop.speed.BenchmarkPlan;
import org.robonewbie.workshop.speed.BenchmarkReport;
import org.robonewbie.workshop.speed.CrowdScene;
import org.robonewbie.workshop.speed.ServerAddress;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Option;

/** Benchmark of a server with 1 to 22 robots. */
@Command(
        name = "speed",
        description = "Measure how fast the simulator is with 1 to 22 robots that stand, walk or lie in a heap.",
        sortOptions = false,
        footer = {
            "",
            "The processor time is that of the server alone; the real-time factor includes" + " the agents.",
            "",
            "Examples:",
            "  bench speed",
            "  bench speed --robots 1,22 --scene walking --seconds 60 --json result.json",
            "  bench speed --robots 1 --scene walking --seconds 20000 --heap-every 2000      10^6 cycles: is there a memory leak?",
            "  bench speed --json figures.json --table table.md      the table in docs/performance.md",
            "  bench speed --host 127.0.0.1 --pid 4711      another server in sync mode, such as rcssserver3d",
            "",
            "To measure a real rcssserver3d, set $agentSyncMode = true and $enableRealTimeMode = false in a copy of its spark.rb in the",
            "folder in which it starts, start it there without a monitor, and find its process with \"pidof rcssserver3d\". Then measure the",
            "server on the same computer, as in the last example; add --port and --monitor-port if its ports are not 3100 and 3200. Robots",
            "join one after the other and are placed through the monitor port. The measurement ends with a message if the server",
            "admits no more robots or sends nothing for 20 s. The reported memory is that of this process, not of the server."
        })
final class SpeedCommand implements Callable<Integer> {

    private static final int MAX_THREADS = 16;
    private static final int MAX_PORT = 65535;

    @Option(
            names = "--robots",
            paramLabel = "N",
            split = ",",
            description = "Numbers of robots to measure, each 1 to 22 (default: 1,2,6,11,22).")
    private List<Integer> robots = List.of(1, 2, 6, 11, 22);

    @Option(
            names = "--scene",
            paramLabel = "SCENE",
            split = ",",
            description = "What the robots do: standing, walking, heap (default: all three).")
    private List<CrowdScene> scenes = List.of(CrowdScene.values());

    @Option(names = "--seconds", paramLabel = "T", description = "Simulated seconds to measure (default: 20).")
    private double seconds = 20;

    @Option(
            names = "--warm-up",
            paramLabel = "T",
            description = "Warm-up for the JIT compiler, in simulated seconds (default: 20).")
    private double warmUpSeconds = 20;

    @Option(
            names = "--heap-every",
            paramLabel = "T",
            description = "Collect garbage and print the memory in use every T simulated seconds.")
    private Optional<Double> heapEvery = Optional.empty();

    @Option(
            names = "--threads",
            paramLabel = "N",
            description = "Number of threads for the embedded server and for the agents, 1 to 16 (default: 1).")
    private int threads = 1;

    @Option(names = "--json", paramLabel = "FILE", description = "Also write the results as JSON.")
    private Optional<Path> json = Optional.empty();

    @Option(names = "--table", paramLabel = "FILE", description = "Also write the results as a Markdown table.")
    private Optional<Path> table = Optional.empty();

    @Option(
            names = "--host",
            paramLabel = "H",
            description = "Measure the server on the given computer instead of the embedded one.")
    private Optional<String> host = Optional.empty();

    @Option(names = "--port", paramLabel = "N", description = "Agent port of the server to measure (default: 3100).")
    private int port = 3100;

    @Option(
            names = "--monitor-port",
            paramLabel = "N",
            description = "Monitor and trainer port of the server to measure (default: 3200).")
    private int monitorPort = 3200;

    @Option(
            names = "--pid",
            paramLabel = "N",
            description = "Process ID of the server, if it is running on this computer, to measure its processor time.")
    private Optional<Long> processId = Optional.empty();

    private boolean begun;

    @Override
    public Integer call() throws IOException {
        BenchmarkPlan plan = plan();
        json.ifPresent(SpeedCommand::checkFolder);
        table.ifPresent(SpeedCommand::checkFolder);
        BenchmarkReport report =
                new Benchmark(plan).run(run -> print(BenchmarkReport.line(run)), sample -> print(sample.toLine()));
        if (json.isPresent()) {
            AtomicFile.write(json.get(), report.toJson());
        }
        if (table.isPresent()) {
            AtomicFile.write(table.get(), report.toMarkdown());
        }
        return ExitCode.OK;
    }

    /** Prints the header before the first line. */
    private void print(String line) {
        if (!begun) {
            System.out.print(BenchmarkReport.header());
            begun = true;
        }
        System.out.print(line);
    }

    private BenchmarkPlan plan() {
        robots.forEach(number -> Bench.checked("--robots", number, 1, Bench.MAX_ROBOTS));
        Bench.checkSeconds("--seconds", seconds);
        Bench.checkSeconds("--warm-up", warmUpSeconds);
        heapEvery.ifPresent(distance -> Bench.checkSeconds("--heap-every", distance));
        Bench.checked("--threads", threads, 1, MAX_THREADS);
        Bench.checked("--port", port, 1, MAX_PORT);
        Bench.checked("--monitor-port", monitorPort, 1, MAX_PORT);
        OptionalDouble heap = heapEvery.map(OptionalDouble::of).orElse(OptionalDouble.empty());
        return new BenchmarkPlan(robots, scenes, warmUpSeconds, seconds, heap, threads, host.map(this::address));
    }

    private ServerAddress address(String name) {
        return new ServerAddress(
                name, port, monitorPort, processId.map(OptionalLong::of).orElse(OptionalLong.empty()));
    }

    /** Rejects an unwritable folder before the measurement, not after it. */
    private static void checkFolder(Path file) {
        Path folder = Objects.requireNonNullElse(file.toAbsolutePath().getParent(), file.toAbsolutePath());
        if (!Files.isWritable(folder)) {
            throw new IllegalArgumentException(
                    "The results cannot be written to the folder " + folder + ": choose another one.");
        }
    }
}
