package org.robonewbie.studio.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.soccer.MatchEvent;

@Timeout(600)
class MonitoredSimulationTest implements SimulationObserver {

    private static final int ELBOW = NaoModel.of(RobotType.TYPE_4).hingeIndex(Joint.LEFT_ARM_YAW);

    private final BlockingQueue<WorldSnapshot> seen = new LinkedBlockingQueue<>();
    private final List<MatchEvent> events = new CopyOnWriteArrayList<>();
    private Simulator server;
    private Thread robot;
    private MonitoredSimulation watched;

    @BeforeEach
    void start() throws IOException {
        server = serve(0, 0);
        AgentLink link = server.connect();
        robot = new Thread(() -> play(link), "robot");
        robot.start();
        watched = MonitoredSimulation.connect("127.0.0.1", server.monitorPort().orElseThrow());
        watched.addObserver(this);
    }

    @AfterEach
    void end() throws InterruptedException {
        watched.close();
        server.close();
        robot.join();
    }

    private static Simulator serve(int agentPort, int monitorPort) throws IOException {
        return Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner().withSeed(1).withLandscape(Landscape.BOX))
                        .withAgentPort(agentPort)
                        .withMonitorPort(monitorPort)
                        .withAwaitedAgents(1)
                        .withSpeed(4),
                Console.silent());
    }

    /** A robot with toes that bends its left elbow. */
    private static void play(AgentLink link) {
        MessageBuffer message = new MessageBuffer();
        String[] beginning = {
            "(scene rsg/agent/nao/nao_hetero.rsg 4)", "(init (unum 7)(teamname Ada))", "(beam -1 0.5 0)"
        };
        try {
            for (int i = 0; ; i++) {
                message.clear();
                message.append((i < beginning.length ? beginning[i] : i < 60 ? "(lae4 -1)" : "(lae4 0)") + "(syn)");
                link.send(message);
                if (!link.receive(message)) {
                    return;
                }
            }
        } catch (IOException over) {
            // The server has ended.
        }
    }

    @Override
    public void cycleEnded(WorldSnapshot snapshot) {
        seen.add(snapshot);
    }

    @Override
    public void happened(MatchEvent event) {
        events.add(event);
    }

    private WorldSnapshot await(Predicate<WorldSnapshot> condition) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(120);
        WorldSnapshot snapshot = seen.poll(120, TimeUnit.SECONDS);
        while (snapshot != null && !condition.test(snapshot)) {
            snapshot = seen.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
        }
        assertThat(snapshot).as("what should be seen").isNotNull();
        return snapshot;
    }

    /** Waits until the robot has reached its line-up position; orders before that are lost or overridden. */
    private void awaitRobotAtItsPlace() throws InterruptedException {
        await(now -> !now.robots().isEmpty()
                && now.robots().get(0).body().position().distanceTo(new Vector3(-1, 0.5, 0.4)) < 0.2);
    }

    @Test
    void robotIsSeenWithItsJoints() throws InterruptedException {
        WorldSnapshot snapshot = await(
                now -> !now.robots().isEmpty() && now.robots().get(0).body().hingeDegrees()[ELBOW] < -45);

        RobotSnapshot seenRobot = snapshot.robots().get(0);
        assertThat(seenRobot.team()).isEqualTo("Ada");
        assertThat(seenRobot.number()).isEqualTo(7);
        assertThat(seenRobot.side()).contains(TeamSide.LEFT);
        assertThat(seenRobot.type()).isEqualTo(RobotType.TYPE_4);
        assertThat(seenRobot.body().hingeDegrees()[ELBOW]).isBetween(-75.0, -45.0);
        assertThat(seenRobot.body().hingeDegrees()[ELBOW + 1]).isCloseTo(0, within(3.0));
        assertThat(seenRobot.body().position().x()).isCloseTo(-1, within(0.2));
        assertThat(watched.field().length()).isEqualTo(12);
        assertThat(watched.field().penaltyWidth()).isCloseTo(2.6, within(1e-6));
    }

    @Test
    void obstaclesOnThePitchAreFound() throws InterruptedException {
        WorldSnapshot snapshot = await(now -> !now.things().isEmpty());

        Thing original = Landscape.BOX.things().get(0);
        assertThat(snapshot.things()).hasSize(1);
        assertThat(snapshot.things().get(0).size().distanceTo(original.size())).isLessThan(1e-5);
        assertThat(snapshot.things().get(0).centre().distanceTo(original.centre()))
                .isLessThan(0.01);
    }

    @Test
    void trainerOrdersGoThroughThePort() throws InterruptedException {
        awaitRobotAtItsPlace();

        watched.order(new Order.PlaceRobot(new PlayerNumber(TeamSide.LEFT, 7), new Vector3(2, 1, 0.4), 90));
        watched.order(new Order.MoveBall(new Vector3(-2, 1, 0.042), Vector3.ZERO));
        watched.order(new Order.DropBall());
        await(now -> now.playMode() == PlayMode.PLAY_ON
                && now.ballPosition().x() < -1.5
                && now.robots().get(0).body().position().x() > 1.5);
        watched.order(new Order.KickOff(TeamSide.LEFT));
        await(now -> now.playMode() == PlayMode.KICK_OFF_LEFT);
        watched.order(new Order.ChangePlayMode(PlayMode.CORNER_KICK_RIGHT));
        await(now -> now.playMode() == PlayMode.CORNER_KICK_RIGHT);
        await(now -> now.gameTime() > 2);
        watched.order(new Order.Reset());

        WorldSnapshot reset = await(now -> now.gameTime() < 1);
        assertThat(reset.ballPosition().length()).isLessThan(0.1);
    }

    @Test
    void goalsAreReported() throws InterruptedException {
        awaitRobotAtItsPlace();
        watched.order(new Order.DropBall());
        await(now -> now.playMode() == PlayMode.PLAY_ON);

        watched.order(new Order.MoveBall(new Vector3(6.2, 0, 0.1), Vector3.ZERO));

        WorldSnapshot scored = await(now -> now.scoreLeft() == 1);
        assertThat(scored.teamLeft()).isEqualTo("Ada");
        assertThat(events).contains(new MatchEvent.GoalScored(TeamSide.LEFT, "Ada"));
    }

    @Test
    void clockOfAnotherProcessCannotBeStopped() {
        assertThat(watched.hasClock()).isFalse();
        assertThatThrownBy(() -> watched.order(new Order.Pause()))
                .hasMessage("A simulation in another process cannot be paused or sped up.");
    }

    @Test
    void reconnectsToARestartedServer() throws Exception {
        await(now -> !now.robots().isEmpty());
        int port = server.monitorPort().orElseThrow();
        server.close();
        robot.join();

        server = serve(0, port);
        robot = new Thread(() -> play(server.connect()), "robot");
        seen.clear();
        robot.start();

        await(now -> !now.robots().isEmpty());
    }
}
