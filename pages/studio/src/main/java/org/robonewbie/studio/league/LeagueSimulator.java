package org.robonewbie.studio.league;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.embedded.OpenedView;
import org.robonewbie.studio.monitor.MonitoredSimulation;

/**
 * A running RCSSServerMJ.
 *
 * @param agentPort its TCP port for agents
 * @param started the server, if this program has started it
 * @param match the match as its monitors see it; empty without a view
 * @param view the studio; empty without a view
 */
record LeagueSimulator(
        int agentPort, Optional<LeagueServer> started, Optional<MonitoredSimulation> match, Optional<OpenedView> view)
        implements EmbeddedSimulator {

    static final String HOST = "127.0.0.1";

    @Override
    public AgentLink connect() throws IOException {
        return TcpAgentLink.connect(HOST, agentPort);
    }

    @Override
    public boolean isServer() {
        return true;
    }

    @Override
    public String description() {
        return (started.isPresent() ? "Started RCSSServerMJ" : "Joining the RCSSServerMJ that runs") + " on agent port "
                + agentPort;
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
        view.ifPresent(opened -> opened.view().close());
        match.ifPresent(MonitoredSimulation::close);
        started.ifPresent(LeagueServer::close);
    }
}
