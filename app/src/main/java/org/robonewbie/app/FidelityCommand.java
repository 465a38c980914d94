package org.robonewbie.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.simulator.fidelity.FidelityBench;
import org.robonewbie.simulator.fidelity.FidelityReport;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Replays recordings of a real rcssserver3d and tells how closely the simulator follows them. */
@Command(
        name = "fidelity",
        description = "Replay recordings of a real rcssserver3d and measure how closely the simulator follows them.",
        footer = {
            "",
            "Examples:",
            "  robonewbie fidelity                       the recordings that come with RoboNewbie",
            "  robonewbie fidelity my-recordings --json result.json"
        })
final class FidelityCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            arity = "0..1",
            paramLabel = "DIRECTORY",
            description = "Folder with recordings (*.jsonl, *.jsonl.gz); without it, those that come with RoboNewbie.")
    private Optional<Path> directory = Optional.empty();

    @Option(names = "--json", paramLabel = "FILE", description = "Write the results as JSON too.")
    private Optional<Path> json = Optional.empty();

    @Mixin
    final WithoutStudioOption withoutStudio = new WithoutStudioOption();

    @Override
    public Integer call() throws IOException {
        directory.filter(folder -> !Files.isDirectory(folder)).ifPresent(folder -> {
            throw new CalledWronglyException(
                    folder + " is not a folder. Name one with recordings (*.jsonl, *.jsonl.gz).");
        });
        FidelityReport report = directory.isPresent() ? FidelityBench.run(directory.get()) : FidelityBench.run();
        System.out.print(report.toTable());
        if (json.isPresent()) {
            write(json.get(), report.toJson());
        }
        return ExitCode.OK;
    }

    /** Writes beside the file first, so that the file is never half a result. */
    private static void write(Path file, String text) throws IOException {
        Path draft = file.resolveSibling(file.getFileName() + ".new");
        Files.writeString(draft, text);
        Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING);
    }
}
