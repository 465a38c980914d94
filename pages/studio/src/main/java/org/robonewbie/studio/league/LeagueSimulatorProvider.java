package org.robonewbie.studio.league;

import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.embedded.ViewedSimulator;
import org.robonewbie.studio.StudioViewer;

/** Finds the RCSSServerMJ of this computer or starts it, for programs that play with one of its robots. */
public final class LeagueSimulatorProvider implements SimulatorProvider {

    private static final Set<String> ROBOTS = Set.of("T1", "K1");

    /** Creates the provider. */
    public LeagueSimulatorProvider() {}

    @Override
    public boolean has(String robot) {
        return ROBOTS.contains(robot);
    }

    @Override
    public EmbeddedSimulator start(SimulatorRequest request) throws IOException {
        int agentPort = request.agentPort();
        int monitorPort = agentPort + 1;
        Optional<LeagueServer> started =
                isRunning(agentPort) ? Optional.empty() : Optional.of(LeagueServer.start(agentPort, monitorPort));
        LeagueSimulator simulator = new LeagueSimulator(agentPort, monitorPort, request.agent(), started);
        return ViewedSimulator.open(simulator, request, Optional.of(new StudioViewer()));
    }

    private static boolean isRunning(int agentPort) {
        try {
            TcpAgentLink.connect(LeagueSimulator.HOST, agentPort).close();
            return true;
        } catch (IOException silent) {
            return false;
        }
    }
}
