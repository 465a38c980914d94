package org.robonewbie.workshop;

import java.io.IOException;
import java.net.ServerSocket;
import org.junit.jupiter.api.Assumptions;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.studio.league.LeagueServer;
import org.robonewbie.studio.monitor.MonitoredSimulation;

/**
 * A real RCSSServerMJ on free ports, as fast as its agents, and its match as monitors see it.
 *
 * @param server the server
 * @param agentPort TCP port for agents
 * @param match the match
 */
public record RunningLeagueServer(LeagueServer server, int agentPort, MonitoredSimulation match)
        implements AutoCloseable {

    private static final String HOST = "127.0.0.1";

    /**
     * Starts a server. Skips the calling test if none is installed, unless the environment variable ROBONEWBIE_REQUIRE_TOOLS is set.
     *
     * @return the server
     * @throws IOException if it does not start
     */
    public static RunningLeagueServer orSkip() throws IOException {
        boolean isRequired = System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null;
        Assumptions.assumeTrue(isRequired || LeagueServer.find().isPresent(), "RCSSServerMJ is not installed");
        int agentPort = freePort();
        int monitorPort = freePort();
        LeagueServer server = LeagueServer.start(agentPort, monitorPort, "--no-realtime");
        return new RunningLeagueServer(server, agentPort, MonitoredSimulation.connect(HOST, monitorPort));
    }

    private static int freePort() throws IOException {
        try (ServerSocket port = new ServerSocket(0)) {
            return port.getLocalPort();
        }
    }

    /**
     * Connects an agent.
     *
     * @return the agent's end of the connection
     * @throws IOException if the server does not answer
     */
    public AgentLink connect() throws IOException {
        return TcpAgentLink.connect(HOST, agentPort);
    }

    @Override
    public void close() {
        match.close();
        server.close();
    }
}
