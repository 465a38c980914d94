package org.robonewbie.studio.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.OptionalInt;
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
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.server.Console;
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
                SimulatorSettings.beginner()
                        .agentPort(agentPort)
                        .monitorPort(OptionalInt.of(monitorPort))
                        .synchronous(true)
                        .awaitedAgents(1)
                        .speed(4)
                        .seed(1)
                        .build(),
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
        WorldSnapshot snapshot = seen.poll(120, TimeUnit.SECONDS);
        while (snapshot != null && !condition.test(snapshot)) {
            snapshot = seen.poll(120, TimeUnit.SECONDS);
        }
        assertThat(snapshot).as("what should be seen").isNotNull();
        return snapshot;
    }

    @Test
    void robotIsSeenWithItsJoints() throws InterruptedException {
        WorldSnapshot snapshot =
                await(now -> !now.robots().isEmpty() && now.robots().get(0).jointDegrees()[ELBOW] < -45);

        RobotSnapshot seenRobot = snapshot.robots().get(0);
        assertThat(seenRobot.team()).isEqualTo("Ada");
        assertThat(seenRobot.number()).isEqualTo(7);
        assertThat(seenRobot.side()).contains(TeamSide.LEFT);
        assertThat(seenRobot.type()).isEqualTo(RobotType.TYPE_4);
        assertThat(seenRobot.jointDegrees()[ELBOW]).isBetween(-75f, -45f);
        assertThat(seenRobot.jointDegrees()[ELBOW + 1]).isCloseTo(0f, within(3f));
        assertThat(seenRobot.linkPoses()[0]).isCloseTo(-1f, within(0.2f));
        assertThat(watched.field().length()).isEqualTo(12);
        assertThat(watched.field().penaltyWidth()).isCloseTo(2.6, within(1e-6));
    }

    @Test
    void trainerOrdersGoThroughThePort() throws InterruptedException {
        await(now -> !now.robots().isEmpty());

        watched.placeRobot(TeamSide.LEFT, 7, new Vector3(2, 1, 0.4), 90);
        watched.placeBall(new Vector3(-2, 1, 0.042), Vector3.ZERO);
        watched.dropBall();
        await(now -> now.playMode() == PlayMode.PLAY_ON
                && now.ballPosition().x() < -1.5
                && now.robots().get(0).linkPoses()[0] > 1.5);
        watched.kickOff(TeamSide.LEFT);
        await(now -> now.playMode() == PlayMode.KICK_OFF_LEFT);
        watched.setPlayMode(PlayMode.CORNER_KICK_RIGHT);
        await(now -> now.playMode() == PlayMode.CORNER_KICK_RIGHT);
        await(now -> now.gameTime() > 2);
        watched.reset();

        WorldSnapshot reset = await(now -> now.gameTime() < 1);
        assertThat(reset.ballPosition().length()).isLessThan(0.1);
    }

    @Test
    void goalsAreReported() throws InterruptedException {
        await(now -> !now.robots().isEmpty());
        watched.dropBall();
        await(now -> now.playMode() == PlayMode.PLAY_ON);

        watched.placeBall(new Vector3(6.2, 0, 0.1), Vector3.ZERO);

        WorldSnapshot scored = await(now -> now.scoreLeft() == 1);
        assertThat(scored.teamLeft()).isEqualTo("Ada");
        assertThat(events).contains(new MatchEvent.GoalScored(TeamSide.LEFT, "Ada"));
    }

    @Test
    void clockOfAnotherProcessCannotBeStopped() {
        assertThat(watched.hasClock()).isFalse();
        assertThatThrownBy(watched::pause).hasMessage("A monitor cannot stop or speed up a server of another process.");
    }

    @Test
    void serverThatStartsAgainIsFound() throws Exception {
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
