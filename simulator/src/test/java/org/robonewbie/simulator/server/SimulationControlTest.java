package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;

@Timeout(60)
class SimulationControlTest {

    private final BlockingQueue<WorldSnapshot> snapshots = new LinkedBlockingQueue<>();
    private Simulator simulator;
    private SimulationControl control;

    @BeforeEach
    void startWithOneRobot() throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.beginner()
                        .agentPort(0)
                        .synchronous(true)
                        .speed(SimulationControl.AS_FAST_AS_POSSIBLE)
                        .awaitedAgents(1)
                        .build(),
                new RecordingConsole());
        control = simulator.control();
        control.addObserver(snapshots::add);
        new ScriptedAgent(simulator.connect(), "Stars", 1).start();
    }

    @AfterEach
    void close() {
        simulator.close();
    }

    @Test
    void pausedWorldIsReportedAgainAndAgain() throws InterruptedException {
        control.pause();
        WorldSnapshot first = await(WorldSnapshot::paused);
        WorldSnapshot second = await(WorldSnapshot::paused);

        assertThat(second.cycle()).isEqualTo(first.cycle());
    }

    @Test
    void stepRunsTheWantedCyclesAndPauses() throws InterruptedException {
        control.pause();
        long before = await(WorldSnapshot::paused).cycle();

        control.step(3);
        WorldSnapshot after = await(snapshot -> snapshot.cycle() == before + 3);
        WorldSnapshot later = await(WorldSnapshot::paused);

        assertThat(after.cycle()).isEqualTo(before + 3);
        assertThat(later.cycle()).isEqualTo(before + 3);
    }

    @Test
    void messagesOfAnAgentAreToldToThoseWhoWantThem() throws InterruptedException {
        BlockingQueue<AgentMessages> heard = new LinkedBlockingQueue<>();
        AtomicInteger wanted = new AtomicInteger(-1);

        control.addObserver(new SimulationObserver() {
            @Override
            public void cycleEnded(WorldSnapshot snapshot) {
                wanted.set(
                        snapshot.robots().isEmpty()
                                ? -1
                                : snapshot.robots().get(0).id());
            }

            @Override
            public boolean wantsMessagesOf(int robot) {
                return robot == wanted.get();
            }

            @Override
            public void messagesExchanged(AgentMessages messages) {
                heard.add(messages);
            }
        });
        AgentMessages told = Objects.requireNonNull(heard.poll(20, TimeUnit.SECONDS));
        while (!told.effectors().contains("(syn)") || told.perceptors().isEmpty()) {
            told = Objects.requireNonNull(heard.poll(20, TimeUnit.SECONDS));
        }

        assertThat(told.robot()).isEqualTo(wanted.get());
        assertThat(told.perceptors())
                .startsWith("(time (now " + String.format(Locale.ROOT, "%.2f", told.cycle() * 0.02) + "))");
    }

    @Test
    void resumedWorldGoesOn() throws InterruptedException {
        control.pause();
        long before = await(WorldSnapshot::paused).cycle();

        control.resume();

        assertThat(await(snapshot -> snapshot.cycle() > before + 10).paused()).isFalse();
    }

    @Test
    void speedIsKept() throws InterruptedException {
        control.setSpeed(5);
        WorldSnapshot start = await(snapshot -> snapshot.speed() == 5);
        long beginning = System.nanoTime();

        await(snapshot -> snapshot.cycle() >= start.cycle() + 100);

        double seconds = (System.nanoTime() - beginning) / 1e9;
        assertThat(seconds).isGreaterThan(0.35);
    }

    @Test
    void ballAndRobotArePlaced() throws InterruptedException {
        await(snapshot -> snapshot.cycle() > 20);
        control.pause();
        await(WorldSnapshot::paused);

        control.placeBall(new Vector3(1, 2, 0.5), new Vector3(0, 0, 0));
        control.placeRobot(TeamSide.LEFT, 1, new Vector3(-2, -3, 0.4), 90);
        WorldSnapshot placed = await(snapshot -> snapshot.ballPosition().y() == 2);

        float[] torso = placed.robots().get(0).linkPoses();
        assertThat(torso[0]).isCloseTo(-2, within(1e-4f));
        assertThat(torso[1]).isCloseTo(-3, within(1e-4f));
        assertThat(forwardY(placed.robots().get(0))).isCloseTo(1, within(1e-3));
    }

    @Test
    void pushedRobotFliesAway() throws InterruptedException {
        float y = await(snapshot -> snapshot.cycle() > 20).robots().get(0).linkPoses()[1];

        control.pushRobot(TeamSide.LEFT, 1, new Vector3(0, 1000, 0));

        WorldSnapshot pushed = await(snapshot -> snapshot.robots().get(0).linkPoses()[1] > y + 0.5);
        assertThat(pushed.robots().get(0).linkPoses()[2]).isLessThan(0.6f);
    }

    @Test
    void refereeCanBeOverruled() throws InterruptedException {
        control.setPlayMode(PlayMode.GOAL_KICK_LEFT);
        await(snapshot -> snapshot.playMode() == PlayMode.GOAL_KICK_LEFT);
        control.dropBall();
        await(snapshot -> snapshot.playMode() == PlayMode.PLAY_ON);
        control.kickOff(TeamSide.RIGHT);

        assertThat(await(snapshot -> snapshot.playMode() == PlayMode.KICK_OFF_RIGHT)
                        .ballPosition()
                        .x())
                .isCloseTo(0, within(0.01));
    }

    @Test
    void resetBringsRobotsBackToWhereTheyWereBeamed() throws InterruptedException {
        WorldSnapshot before = await(snapshot -> snapshot.cycle() > 100);
        control.pause();
        await(WorldSnapshot::paused);

        control.reset();
        WorldSnapshot after = await(snapshot -> snapshot.gameTime() == 0);

        RobotSnapshot robot = after.robots().get(0);
        assertThat(before.gameTime()).isPositive();
        assertThat(robot.number()).isEqualTo(1);
        assertThat(robot.linkPoses()[0]).isCloseTo(-1, within(1e-4f));
        assertThat(robot.linkPoses()[1]).isCloseTo(1, within(1e-4f));
        for (float degrees : robot.jointDegrees()) {
            assertThat((double) degrees).isCloseTo(0, within(1e-6));
        }
    }

    /** Waits for a snapshot that is as wanted. */
    private WorldSnapshot await(Predicate<WorldSnapshot> wanted) throws InterruptedException {
        while (true) {
            WorldSnapshot snapshot = snapshots.poll(30, TimeUnit.SECONDS);
            assertThat(snapshot).isNotNull();
            if (wanted.test(snapshot)) {
                return snapshot;
            }
        }
    }

    /** How far the torso's forward axis points along y. */
    private static double forwardY(RobotSnapshot robot) {
        double z = robot.linkPoses()[6];
        return 1 - 2 * z * z;
    }
}
