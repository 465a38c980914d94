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
    private final Optional<OpenedView> view;
    private final Optional<TelemetryServer> telemetryServer;

    ViewedSimulator(Simulator simulator, LocalProgram program, Optional<OpenedView> view) {
        this.simulator = simulator;
        this.program = program;
        this.view = view;
        this.telemetryServer = view.flatMap(
                opened -> listen(simulator.agentPort(), opened.view().telemetry()));
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
        return view.map(OpenedView::address);
    }

    @Override
    public TelemetrySink telemetry() {
        return view.map(opened -> opened.view().telemetry()).orElse(TelemetrySink.NONE);
    }

    @Override
    public void close() {
        program.awaitReplacement();
        telemetryServer.ifPresent(TelemetryServer::close);
        view.ifPresent(opened -> opened.view().close());
        simulator.close();
    }
}
