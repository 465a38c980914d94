package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TelemetryServer;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.server.Simulator;

/** A simulator with an optional view in the browser. */
final class ViewedSimulator implements EmbeddedSimulator {

    private final Simulator simulator;
    private final LocalProgram program;
    private final Optional<Viewer.View> view;
    private final String hint;
    private final Optional<TelemetryServer> telemetryServer;

    ViewedSimulator(Simulator simulator, LocalProgram program, Optional<Viewer.View> view, String hint) {
        this.simulator = simulator;
        this.program = program;
        this.view = view;
        this.hint = hint;
        this.telemetryServer = view.flatMap(opened -> listen(simulator.agentPort(), opened.telemetry()));
    }

    /**
     * Starts the telemetry server. Robots in other processes work without the server, so a port in use is not an error.
     */
    private static Optional<TelemetryServer> listen(int agentPort, TelemetrySink sink) {
        try {
            return Optional.of(TelemetryServer.open(TelemetryServer.portFor(agentPort), sink));
        } catch (IOException portInUse) {
            return Optional.empty();
        }
    }

    @Override
    public AgentLink connect() {
        return program.connect();
    }

    @Override
    public int agentPort() {
        return simulator.agentPort();
    }

    @Override
    public Optional<String> studioAddress() {
        return view.map(opened -> opened.oneTimeAddress() + hint);
    }

    @Override
    public TelemetrySink telemetry() {
        return view.map(Viewer.View::telemetry).orElse(TelemetrySink.NONE);
    }

    @Override
    public void close() {
        program.awaitReplacement();
        telemetryServer.ifPresent(TelemetryServer::close);
        view.ifPresent(Viewer.View::close);
        simulator.close();
    }
}
