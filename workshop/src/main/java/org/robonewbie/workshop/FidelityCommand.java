package org.robonewbie.workshop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.workshop.fidelity.AgentRoute;
import org.robonewbie.workshop.fidelity.FidelityBench;
import org.robonewbie.workshop.fidelity.FidelityReport;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Replays recordings of a real rcssserver3d and measures how closely the simulator follows them. */
@Command(
        name = "fidelity",
        description = "Replay recordings of a real rcssserver3d and measure how closely the simulator follows them.",
        footer = {
            "",
            "Examples:",
            "  bench fidelity                       the recordings that come with RoboNewbie",
            "  bench fidelity my-recordings --json result.json",
            "  bench fidelity --link tcp            the same with an agent connected over TCP"
        })
final class FidelityCommand implements Callable<Integer> {

    @Parameters(
            arity = "0..1",
            paramLabel = "DIRECTORY",
            description = "Folder with recordings (*.jsonl, *.jsonl.gz); default: the recordings that come"
                    + " with RoboNewbie.")
    private Optional<Path> directory = Optional.empty();

    @Option(
            names = "--link",
            paramLabel = "LINK",
            defaultValue = "none",
            description = "How the recorded commands reach the robot: none applies them directly to the"
                    + " world; in-process and tcp send them as agent messages through a full server"
                    + " (default: none).")
    private String link = "none";

    @Option(names = "--json", paramLabel = "FILE", description = "Also write the results as JSON.")
    private Optional<Path> json = Optional.empty();

    @Override
    public Integer call() throws IOException {
        directory.filter(folder -> !Files.isDirectory(folder)).ifPresent(folder -> {
            throw new IllegalArgumentException(
                    folder + " is not a folder. Choose one with recordings (*.jsonl, *.jsonl.gz).");
        });
        AgentRoute route = route();
        FidelityReport report =
                directory.isPresent() ? FidelityBench.run(directory.get(), route) : FidelityBench.run(route);
        System.out.print(report.toTable());
        report.problems().forEach(System.err::println);
        if (json.isPresent()) {
            AtomicFile.write(json.get(), report.toJson());
        }
        return report.problems().isEmpty() ? ExitCode.OK : ExitCode.SOFTWARE;
    }

    private AgentRoute route() {
        return switch (link) {
            case "none" -> AgentRoute.NONE;
            case "in-process" -> AgentRoute.IN_PROCESS;
            case "tcp" -> AgentRoute.TCP;
            default ->
                throw new IllegalArgumentException("Unknown link \"" + link + "\". Use none, in-process or tcp.");
        };
    }
}
