package org.robonewbie.simulator.monitor;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** A world with a monitor port, driven cycle by cycle by a test. */
final class WatchedWorld implements AutoCloseable {

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private final List<Robot> robots = new ArrayList<>();
    private final List<String> console = new CopyOnWriteArrayList<>();
    private final BlockingQueue<Order> orders = new LinkedBlockingQueue<>();
    private final MonitorPort port;
    private float shift;
    private long cycle;

    WatchedWorld() throws IOException {
        port = MonitorPort.open(settings(0), console::add, orders::add);
    }

    static MonitorSettings settings(int port) {
        return new MonitorSettings("127.0.0.1", port, MonitorSettings.DEFAULT_STEP_SECONDS, SoccerParameters.league());
    }

    MonitorPort port() {
        return port;
    }

    SoccerWorld world() {
        return world;
    }

    List<String> console() {
        return console;
    }

    /** Connects a monitor and waits until the port knows it. */
    MonitorLink connect() throws IOException {
        int before = port.monitors();
        MonitorLink link = MonitorLink.connect("127.0.0.1", port.number());
        awaitMonitors(before + 1);
        return link;
    }

    /** Waits until the port knows as many monitors; the test's time limit ends the waiting. */
    void awaitMonitors(int count) {
        try {
            port.awaitMonitors(count);
        } catch (InterruptedException isOver) {
            throw new AssertionError(isOver);
        }
    }

    Order nextOrder() throws InterruptedException {
        Order order = orders.poll(100, TimeUnit.SECONDS);
        if (order == null) {
            throw new AssertionError("No command has arrived");
        }
        return order;
    }

    Robot addRobot() {
        Robot robot = world.addRobot(RobotType.TYPE_0);
        robots.add(robot);
        return robot;
    }

    /** Advances the real world. */
    void runCycles(int count) {
        for (int i = 0; i < count; i++) {
            world.step();
            port.cycleEnded(cycle++, this::snapshot);
        }
    }

    /** Shows everything at another place without the cost of physics, so that each message is long. */
    void jump() {
        shift += 0.1f;
        port.show(snapshot());
    }

    MonitorSnapshot snapshot() {
        List<MonitoredRobotState> states = new ArrayList<>();
        for (int i = 0; i < robots.size(); i++) {
            TeamSide side = i % 2 == 0 ? TeamSide.LEFT : TeamSide.RIGHT;
            MonitoredRobotState state =
                    MonitoredRobotState.of(i, robots.get(i), Optional.of(new PlayerNumber(side, 1 + i / 2)), false);
            for (int x = 12; x < state.transforms().length; x += 16) {
                state.transforms()[x] += shift;
            }
            states.add(state);
        }
        MonitoredGame game = new MonitoredGame(
                cycle * 0.02, Optional.of("us"), Optional.empty(), 1, 0, 0, Optional.of(PlayMode.PLAY_ON), 0, 0);
        return MonitorSnapshot.of(game, List.of(), world, states);
    }

    @Override
    public void close() {
        port.close();
    }
}
