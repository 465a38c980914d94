package org.robonewbie.simulator.embedded;

import java.net.URI;
import java.util.Optional;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.Viewer;
import org.robonewbie.simulator.server.Simulator;

/** A simulator with an optional view in the browser. */
final class ViewedSimulator implements EmbeddedSimulator {

    private final Simulator simulator;
    private final Optional<Viewer.View> view;

    ViewedSimulator(Simulator simulator, Optional<Viewer.View> view) {
        this.simulator = simulator;
        this.view = view;
    }

    @Override
    public AgentLink connect() {
        return simulator.connect();
    }

    @Override
    public int agentPort() {
        return simulator.agentPort();
    }

    @Override
    public Optional<URI> studioAddress() {
        return view.map(Viewer.View::address);
    }

    @Override
    public void close() {
        view.ifPresent(Viewer.View::close);
        simulator.close();
    }
}
