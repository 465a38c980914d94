package org.robonewbie.studio.league;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.JoinableSimulator;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.studio.monitor.MonitoredSimulation;

/** A running RCSSServerMJ on this computer. */
final class LeagueSimulator implements JoinableSimulator {

    static final String HOST = "127.0.0.1";

    private final int agentPort;
    private final int monitorPort;
    private final String agent;
    private final Optional<LeagueServer> started;
    private final CountDownLatch end = new CountDownLatch(1);
    private volatile Optional<MonitoredSimulation> match = Optional.empty();

    /**
     * Creates the simulator.
     *
     * @param agentPort TCP port for agents
     * @param monitorPort TCP port for monitors
     * @param agent name of the program, for the recording
     * @param started the server, if this program has started it
     */
    LeagueSimulator(int agentPort, int monitorPort, String agent, Optional<LeagueServer> started) {
        this.agentPort = agentPort;
        this.monitorPort = monitorPort;
        this.agent = agent;
        this.started = started;
    }

    @Override
    public AgentLink connect() throws IOException {
        return TcpAgentLink.connect(HOST, agentPort);
    }

    @Override
    public int agentPort() {
        return agentPort;
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

    /** Returns the match as its monitors see it; it is recorded from now on. */
    @Override
    public SimulationControl control() throws IOException {
        MonitoredSimulation watched = MonitoredSimulation.connect(
                HOST,
                monitorPort,
                OptionalInt.of(agentPort),
                () -> RecordingRepository.ofUser().flatMap(recordings -> recordings.next(agent)));
        match = Optional.of(watched);
        return watched;
    }

    @Override
    public void awaitEnd() throws InterruptedException {
        end.await();
    }

    @Override
    public void close() {
        match.ifPresent(MonitoredSimulation::close);
        started.ifPresent(LeagueServer::close);
        end.countDown();
    }
}
