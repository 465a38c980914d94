package org.robonewbie.simulator.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.cycle.WorldSettings;

/** A server with the rules of the league that waits for its agents, all of which connect by TCP. */
final class LeagueServer implements AutoCloseable {

    final RecordingConsole console = new RecordingConsole();
    final WorldWatcher watcher = new WorldWatcher();
    final Simulator simulator;

    private final List<TestAgent> agents = new ArrayList<>();

    LeagueServer() throws IOException {
        this(true);
    }

    LeagueServer(boolean synchronous) throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.league().withSeed(5).withSynchronous(synchronous))
                        .withAgentPort(0)
                        .withMonitorPort(0)
                        .withAwaitedAgents(synchronous ? 1 : 0)
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE),
                console);
        simulator.control().addObserver(watcher);
    }

    TestAgent connect() throws IOException {
        TestAgent agent = new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()));
        agents.add(agent);
        return agent;
    }

    /** Connects an agent that has joined and whose first messages are over. */
    TestAgent join(String team, int number) throws IOException {
        TestAgent agent = connect();
        agent.join(team, number);
        return agent;
    }

    /** Connects an agent that has been on the pitch for 60 cycles of play. */
    TestAgent joinPlay(SimulationObserver observer) throws IOException {
        TestAgent agent = join("Ada", 1);
        agent.exchange("(beam -2 0 0)(syn)");
        control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        control().addObserver(observer);
        cycles(agent, 60);
        return agent;
    }

    MonitorLink monitor() throws IOException {
        return MonitorLink.connect("127.0.0.1", simulator.monitorPort().orElseThrow());
    }

    SimulationControl control() {
        return simulator.control();
    }

    /** Lets cycles pass with a single agent; returns the play mode afterwards. */
    static PlayMode cycles(TestAgent agent, int count) throws IOException {
        PerceptorMessage message = agent.exchange("(syn)");
        for (int i = 1; i < count; i++) {
            message = agent.exchange("(syn)");
        }
        return message.gameState().orElseThrow().playMode().orElseThrow();
    }

    /** Lets cycles pass with several agents, each of which sends the same in each cycle. */
    static void cyclesOfAll(int count, String text, TestAgent... agents) throws IOException {
        for (int i = 0; i < count; i++) {
            for (TestAgent agent : agents) {
                agent.send(text);
            }
            for (TestAgent agent : agents) {
                agent.receiveText();
            }
        }
    }

    double torso(int robot, int axis) {
        Vector3 torso = watcher.latest().robots().get(robot).body().position();
        return axis == 0 ? torso.x() : axis == 1 ? torso.y() : torso.z();
    }

    @Override
    public void close() throws IOException {
        for (TestAgent agent : agents) {
            agent.close();
        }
        simulator.close();
    }
}
