package org.robonewbie.simulator.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.monitor.MonitoredRobot;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.simulator.cycle.WorldSettings;

/** A running simulator of which a test sees only what a monitor sees. */
final class MonitoredSimulator implements AutoCloseable {

    static final PlayerNumber LEFT_1 = new PlayerNumber(TeamSide.LEFT, 1);
    static final PlayerNumber LEFT_2 = new PlayerNumber(TeamSide.LEFT, 2);

    private static final int PATIENCE_MESSAGES = 1000;

    private final RecordingConsole console = new RecordingConsole();
    private final Simulator simulator;
    private final MonitorLink monitor;
    private final List<TestAgent> agents = new ArrayList<>();
    private Consumer<String> reader = message -> {};

    MonitoredSimulator() throws IOException {
        this(true);
    }

    MonitoredSimulator(boolean trainers) throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.league().withNoise(false).withSynchronous(false))
                        .withAgentPort(0)
                        .withMonitors(
                                new SimulatorSettings.Monitors(OptionalInt.of(0), 0.04, trainers, Optional.empty()))
                        .withSpeed(10),
                console);
        monitor = connect();
    }

    List<String> told() {
        return console.sentences();
    }

    Simulator simulator() {
        return simulator;
    }

    MonitorLink monitor() {
        return monitor;
    }

    MonitoredWorld world() {
        return monitor.world();
    }

    MonitorLink connect() throws IOException {
        return MonitorLink.connect("127.0.0.1", simulator.monitorPort().orElseThrow());
    }

    /** Brings a robot onto the pitch and waits until the monitor sees it. */
    TestAgent join(String team, int number) throws IOException {
        int before = world().robots().size();
        TestAgent agent = new TestAgent(simulator.connect());
        agents.add(agent);
        agent.join(team, number);
        await(seen -> seen.robots().size() > before);
        return agent;
    }

    void order(Order.Trainer... orders) throws IOException {
        monitor.send(orders);
    }

    /** Lets somebody read all messages from now on. */
    void setReader(Consumer<String> newReader) {
        reader = newReader;
    }

    /** Reads the next message. */
    void receive() throws IOException {
        if (!monitor.receive()) {
            throw new AssertionError("The simulator has ended");
        }
        reader.accept(monitor.lastMessage().toString());
    }

    /** Reads messages until the world is as wanted. */
    void await(Predicate<MonitoredWorld> wanted) throws IOException {
        for (int i = 0; i < PATIENCE_MESSAGES; i++) {
            receive();
            if (wanted.test(world())) {
                return;
            }
        }
        throw new AssertionError("The monitor has not seen what was expected: " + world().gameState() + ", ball "
                + world().ball().map(TransformNode::position));
    }

    /** Reads messages until a full one has come, and returns it. */
    String awaitFullMessage() throws IOException {
        await(seen -> monitor.lastMessage().toString().contains("(RSG 0 1)"));
        return monitor.lastMessage().toString();
    }

    TransformNode torso(PlayerNumber player) {
        return torso(world().robot(player).orElseThrow());
    }

    static TransformNode torso(MonitoredRobot robot) {
        return robot.link("body").orElseThrow();
    }

    @Override
    public void close() throws IOException {
        monitor.close();
        for (TestAgent agent : agents) {
            agent.close();
        }
        simulator.close();
    }
}
