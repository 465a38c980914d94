package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Random;
import java.util.ServiceLoader;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/**
 * The provider of simulators for beginners, with a small pitch, simple rules and sync mode. {@link ServiceLoader} finds it.
 */
public final class BeginnersSimulatorProvider implements SimulatorProvider {

    private static final int SEEDS = 1_000_000;

    /** Creates the provider. */
    public BeginnersSimulatorProvider() {}

    @Override
    public EmbeddedSimulator start(SimulatorRequest request) throws IOException {
        Simulator simulator = Simulator.start(settings(request), Console.standard());
        return ViewedSimulator.open(
                simulator, request, ServiceLoader.load(Viewer.class).findFirst());
    }

    private static SimulatorSettings settings(SimulatorRequest request) throws IOException {
        boolean truth = request.truth();
        WorldSettings world = WorldSettings.beginner()
                .withSeed(request.seed().orElseGet(() -> (long) new Random().nextInt(SEEDS)))
                .withCamera(CameraSettings.STANDARD.withTruth(truth, truth, truth))
                .withLandscape(landscape(request));
        return SimulatorSettings.of(world)
                .withAgentPort(request.agentPort())
                .withSpeed(request.fast() ? SimulationControl.AS_FAST_AS_POSSIBLE : 1)
                .withAwaitedAgents(request.awaitedAgents())
                .withSeconds(request.seconds().orElse(Double.POSITIVE_INFINITY))
                .withOutput(
                        request.recording().map(Path::of).or(() -> automaticRecording(request)),
                        request.report().map(Path::of));
    }

    private static Landscape landscape(SimulatorRequest request) throws IOException {
        try {
            return request.scene().map(Landscape::named).orElse(Landscape.SOCCER);
        } catch (IllegalArgumentException unknown) {
            throw new IOException(unknown.getMessage(), unknown);
        }
    }

    /** Returns the file for the automatic recording; empty for a run without a view. */
    private static Optional<Path> automaticRecording(SimulatorRequest request) {
        return request.headless()
                ? Optional.empty()
                : RecordingRepository.ofUser().flatMap(recordings -> recordings.next(request.agent()));
    }
}
