package org.robonewbie.workshop;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.workshop.fidelity.FidelityBench;
import org.robonewbie.workshop.fidelity.ReferenceRecorder;
import org.robonewbie.workshop.fidelity.ReferenceScenario;
import org.robonewbie.workshop.fidelity.ReferenceServer;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Option;

/** Records robots and balls on a running server for replay with {@code bench fidelity}. */
@Command(
        name = "record",
        description = {
            "Record robots and balls on a running rcssserver3d (or robonewbie simulator), for \"bench fidelity\" to replay.",
            "",
            "The server must wait for its agents and send a monitor message in each cycle: for a real server, set"
                    + " $agentSyncMode = true, $monitorStep = 0.02 and $threadedMode = false in spark.rb. For exact"
                    + " numbers, also turn off the beam noise (BeamNoiseXY and BeamNoiseAngle 0 in naosoccersim.rb)."
        },
        footer = {
            "",
            "Examples:",
            "  bench record                          ten scenarios into the folder reference",
            "  bench record --host lab7 --out lab7 --type 3",
            "  bench record --scenario h_squat --scenario d_fall_front",
            "  bench record --commands my/h_squat.jsonl.gz   repeat the commands of another recording",
            "  robonewbie simulator --sync --no-noise --monitor-step 0.02 --set BeamNoiseXY=0 --set BeamNoiseAngle=0",
            "                                                       a simulator to try it with",
            "  bench fidelity reference                        compare the recordings"
        })
final class RecordCommand implements Callable<Integer> {

    @Option(
            names = "--host",
            paramLabel = "HOST",
            defaultValue = "127.0.0.1",
            description = "The server's computer (default: ${DEFAULT-VALUE}).")
    private String host = "127.0.0.1";

    @Option(
            names = "--port",
            paramLabel = "N",
            defaultValue = "3100",
            description = "The server's port for agents (default: ${DEFAULT-VALUE}).")
    private int port;

    @Option(
            names = "--monitor-port",
            paramLabel = "N",
            defaultValue = "3200",
            description = "The server's port for monitors (default: ${DEFAULT-VALUE}).")
    private int monitorPort;

    @Option(
            names = "--out",
            paramLabel = "DIRECTORY",
            defaultValue = "reference",
            description = "Folder for the recordings (default: ${DEFAULT-VALUE}).")
    private Path directory = Path.of("reference");

    @Option(
            names = "--type",
            paramLabel = "0..4",
            defaultValue = "0",
            description = "Robot type (default: ${DEFAULT-VALUE}).")
    private int type;

    @Option(names = "--scenario", paramLabel = "NAME", description = "Record only this scenario; may be repeated.")
    private List<String> names = new ArrayList<>();

    @Option(
            names = "--commands",
            paramLabel = "FILE",
            description = "Record a robot that repeats the commands of this recording (.jsonl or .jsonl.gz).")
    private Optional<Path> commands = Optional.empty();

    @Override
    public Integer call() throws IOException {
        Bench.checked("--type", type, 0, Bench.MAX_TYPE);
        List<ReferenceScenario> scenarios = scenarios();
        new ReferenceRecorder(new ReferenceServer(host, port, monitorPort), type, System.out)
                .record(scenarios, directory);
        System.out.println("Recording saved to " + directory + ". Compare with: bench fidelity " + directory);
        return ExitCode.OK;
    }

    private List<ReferenceScenario> scenarios() throws IOException {
        if (commands.isPresent()) {
            return List.of(ReferenceScenario.of(FidelityBench.read(commands.get())));
        }
        List<ReferenceScenario> all = ReferenceScenario.all();
        List<String> known = all.stream().map(ReferenceScenario::name).toList();
        for (String name : names) {
            if (!known.contains(name)) {
                throw new IllegalArgumentException(
                        "Unknown scenario \"" + name + "\". Available: " + String.join(", ", known) + ".");
            }
        }
        return all.stream()
                .filter(scenario -> names.isEmpty() || names.contains(scenario.name()))
                .toList();
    }
}
