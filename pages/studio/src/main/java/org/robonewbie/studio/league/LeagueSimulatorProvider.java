package org.robonewbie.studio.league;

import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.embedded.OpenedView;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.studio.StudioViewer;
import org.robonewbie.studio.monitor.MonitoredSimulation;

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
        try {
            return request.headless()
                    ? new LeagueSimulator(agentPort, started, Optional.empty(), Optional.empty())
                    : watched(new StudioViewer(), request, started, monitorPort);
        } catch (IOException | RuntimeException failed) {
            started.ifPresent(LeagueServer::close);
            throw failed;
        }
    }

    static LeagueSimulator watched(
            Viewer viewer, SimulatorRequest request, Optional<LeagueServer> started, int monitorPort)
            throws IOException {
        MonitoredSimulation match = MonitoredSimulation.connect(
                LeagueSimulator.HOST,
                monitorPort,
                () -> RecordingRepository.ofUser().flatMap(recordings -> recordings.next(request.agent())));
        try {
            OpenedView view = OpenedView.of(viewer.open(match, 0), request.openBrowser());
            return new LeagueSimulator(request.agentPort(), started, Optional.of(match), Optional.of(view));
        } catch (IOException | RuntimeException failed) {
            match.close();
            throw failed;
        }
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
