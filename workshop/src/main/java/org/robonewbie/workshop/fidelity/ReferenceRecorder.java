package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPOutputStream;
import org.robonewbie.nao.file.AtomicFile;

/**
 * Records robots and balls on a running server, a real rcssserver3d or this simulator, in the format that {@link
 * FidelityBench} replays.
 *
 * <p>The server must run in sync mode and send a monitor message in each cycle. The recordings are exact if there is no
 * beam noise and no other robot nearby.
 *
 * <pre>{@code
 * new ReferenceRecorder(new ReferenceServer("127.0.0.1", 3100, 3200), 0, System.out)
 *         .record(ReferenceScenario.all(), Path.of("my-recordings"));
 * }</pre>
 */
public final class ReferenceRecorder {

    private static final int ATTEMPTS = 20;

    private final ReferenceServer server;
    private final int type;
    private final PrintStream progress;

    /**
     * Creates a recorder.
     *
     * @param server address of the server
     * @param type the robot type, 0 to 4
     * @param progress destination of the progress messages
     */
    public ReferenceRecorder(ReferenceServer server, int type, PrintStream progress) {
        this.server = server;
        this.type = type;
        this.progress = progress;
    }

    /**
     * Records scenarios in order, each with a new robot.
     *
     * @param scenarios scenarios to record
     * @param directory directory for one file per scenario; created if missing
     * @throws IOException if the server does not respond as expected or a file cannot be written; the message suggests a fix
     */
    public void record(List<ReferenceScenario> scenarios, Path directory) throws IOException {
        Files.createDirectories(directory);
        for (int i = 0; i < scenarios.size(); i++) {
            ReferenceScenario scenario = scenarios.get(i);
            progress.println("recording " + (i + 1) + " of " + scenarios.size() + ": " + scenario.name() + " ("
                    + scenario.description() + ")");
            write(directory.resolve(scenario.name() + ".jsonl.gz"), scenario, take(scenario));
        }
    }

    private ReferenceSession.Take take(ReferenceScenario scenario) throws IOException {
        for (int attempt = 1; attempt <= ATTEMPTS; attempt++) {
            try (ReferenceSession session = ReferenceSession.open(server)) {
                Optional<ReferenceSession.Take> take = scenario.balls().isEmpty()
                        ? session.record(type, scenario.commands())
                        : Optional.of(session.recordBalls(scenario.balls()));
                if (take.isPresent()) {
                    reportNoise(take.get());
                    return take.get();
                }
            }
            progress.println("  monitor messages were late; retrying");
        }
        throw new IOException("The monitor messages did not match the agent's cycles in " + ATTEMPTS
                + " attempts. Close other programs that use the processor, then try again.");
    }

    private void reportNoise(ReferenceSession.Take take) {
        if (take.isNoisy()) {
            progress.println(
                    "  the server adds noise to beams; set BeamNoiseXY and BeamNoiseAngle to 0 for exact recordings");
        }
    }

    private void write(Path file, ReferenceScenario scenario, ReferenceSession.Take take) throws IOException {
        try (OutputStream packed = new GZIPOutputStream(AtomicFile.begin(file))) {
            String base = scenario.balls().isEmpty()
                    ? "recorded by RoboNewbie, robot type " + type
                            + "; torso from the monitor port (m, deg), the rest as the server sent it"
                    : "recorded by RoboNewbie; ball from the monitor port (m), t counts from the trainer's command";
            packed.write((RowWriter.header(scenario.description(), base, take.way()) + "\n")
                    .getBytes(StandardCharsets.UTF_8));
            for (String line : take.lines()) {
                packed.write((line + "\n").getBytes(StandardCharsets.UTF_8));
            }
        }
        AtomicFile.moveIntoPlace(file);
    }
}
