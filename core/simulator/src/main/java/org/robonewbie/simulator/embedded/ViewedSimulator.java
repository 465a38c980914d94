package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TelemetryServer;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.JoinableSimulator;

/** A simulator with an optional view in the browser, whose pages can replace the program that has started it. */
public final class ViewedSimulator implements EmbeddedSimulator {

    private final JoinableSimulator simulator;
    private final LocalProgram program;
    private final Optional<OpenedView> view;
    private final Optional<TelemetryServer> telemetryServer;

    private ViewedSimulator(JoinableSimulator simulator, LocalProgram program, Optional<OpenedView> view) {
        this.simulator = simulator;
        this.program = program;
        this.view = view;
        this.telemetryServer = view.flatMap(
                opened -> listen(simulator.agentPort(), opened.view().telemetry()));
    }

    /**
     * Opens the view of a simulator, unless it is to run without one.
     *
     * @param simulator the simulator; it is closed if the view cannot be opened
     * @param request what the program wants
     * @param viewer opens the view; empty if there is none
     * @return the simulator with its view
     * @throws IOException if the view cannot be opened
     */
    public static ViewedSimulator open(JoinableSimulator simulator, SimulatorRequest request, Optional<Viewer> viewer)
            throws IOException {
        LocalProgram program = new LocalProgram(simulator, request.agent(), request.robot(), Console.standard());
        if (request.headless() || viewer.isEmpty()) {
            return new ViewedSimulator(simulator, program, Optional.empty());
        }
        try {
            Viewer.View view = viewer.get().open(simulator.control(), 0, program);
            return new ViewedSimulator(simulator, program, Optional.of(OpenedView.of(view, request.openBrowser())));
        } catch (IOException | RuntimeException failed) {
            simulator.close();
            throw failed;
        }
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
    public AgentLink connect() throws IOException {
        return program.connect();
    }

    @Override
    public boolean isServer() {
        return simulator.isServer();
    }

    @Override
    public String description() {
        return simulator.description();
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
