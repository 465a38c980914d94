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
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.WorldSettings;

@Timeout(120)
class SimulationControlTest {

    private final BlockingQueue<WorldSnapshot> snapshots = new LinkedBlockingQueue<>();
    private Simulator simulator;
    private SimulationControl control;

    @BeforeEach
    void startWithOneRobot() throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner())
                        .withAgentPort(0)
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                        .withAwaitedAgents(1),
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
        control.order(new Order.Pause());
        WorldSnapshot first = await(WorldSnapshot::paused);
        WorldSnapshot second = await(WorldSnapshot::paused);

        assertThat(second.cycle()).isEqualTo(first.cycle());
    }

    @Test
    void stepRunsTheWantedCyclesAndPauses() throws InterruptedException {
        control.order(new Order.Pause());
        long before = await(WorldSnapshot::paused).cycle();

        control.order(new Order.Step(3));
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
        AgentMessages told = Objects.requireNonNull(heard.poll(100, TimeUnit.SECONDS));
        while (!told.effectors().contains("(syn)") || told.perceptors().isEmpty()) {
            told = Objects.requireNonNull(heard.poll(100, TimeUnit.SECONDS));
        }

        assertThat(told.robot()).isEqualTo(wanted.get());
        assertThat(told.perceptors())
                .startsWith("(time (now " + String.format(Locale.ROOT, "%.2f", told.cycle() * 0.02) + "))");
    }

    @Test
    void resumedWorldGoesOn() throws InterruptedException {
        control.order(new Order.Pause());
        long before = await(WorldSnapshot::paused).cycle();

        control.order(new Order.Resume());

        assertThat(await(snapshot -> snapshot.cycle() > before + 10).paused()).isFalse();
    }

    @Test
    void ballAndRobotArePlaced() throws InterruptedException {
        await(snapshot -> snapshot.cycle() > 20);
        control.order(new Order.Pause());
        await(WorldSnapshot::paused);

        control.order(new Order.MoveBall(new Vector3(1, 2, 0.5), new Vector3(0, 0, 0)));
        control.order(new Order.PlaceRobot(new PlayerNumber(TeamSide.LEFT, 1), new Vector3(-2, -3, 0.4), 90));
        WorldSnapshot placed = await(snapshot -> snapshot.ballPosition().y() == 2);

        BodyState body = placed.robots().get(0).body();
        assertThat(body.position().x()).isCloseTo(-2, within(1e-4));
        assertThat(body.position().y()).isCloseTo(-3, within(1e-4));
        assertThat(body.headingDegrees()).isCloseTo(90, within(2.5));
    }

    @Test
    void pushedRobotFliesAway() throws InterruptedException {
        double y = await(snapshot -> snapshot.cycle() > 20)
                .robots()
                .get(0)
                .body()
                .position()
                .y();

        control.order(new Order.PushRobot(new PlayerNumber(TeamSide.LEFT, 1), new Vector3(0, 1000, 0)));

        WorldSnapshot pushed =
                await(snapshot -> snapshot.robots().get(0).body().position().y() > y + 0.5);
        assertThat(pushed.robots().get(0).body().position().z()).isLessThan(0.6);
    }

    @Test
    void refereeCanBeOverruled() throws InterruptedException {
        control.order(new Order.ChangePlayMode(PlayMode.FREE_KICK_LEFT));
        await(snapshot -> snapshot.playMode() == PlayMode.FREE_KICK_LEFT);
        control.order(new Order.DropBall());
        await(snapshot -> snapshot.playMode() == PlayMode.PLAY_ON);
        control.order(new Order.KickOff(TeamSide.RIGHT));

        assertThat(await(snapshot -> snapshot.playMode() == PlayMode.KICK_OFF_RIGHT)
                        .ballPosition()
                        .x())
                .isCloseTo(0, within(0.01));
    }

    @Test
    void resetBringsRobotsBackToWhereTheyWereBeamed() throws InterruptedException {
        WorldSnapshot before = await(snapshot -> snapshot.cycle() > 100);
        control.order(new Order.Pause());
        await(WorldSnapshot::paused);

        control.order(new Order.Reset());
        WorldSnapshot after = await(snapshot -> snapshot.gameTime() == 0);

        RobotSnapshot robot = after.robots().get(0);
        assertThat(before.gameTime()).isPositive();
        assertThat(robot.number()).isEqualTo(1);
        assertThat(robot.body().position().x()).isCloseTo(-1, within(1e-4));
        assertThat(robot.body().position().y()).isCloseTo(1, within(1e-4));
        assertThat(robot.body().hingeDegrees())
                .usingComparatorWithPrecision(1e-6)
                .containsOnly(0);
    }

    /** Waits for a snapshot that is as wanted. */
    private WorldSnapshot await(Predicate<WorldSnapshot> wanted) throws InterruptedException {
        while (true) {
            WorldSnapshot snapshot = snapshots.poll(100, TimeUnit.SECONDS);
            assertThat(snapshot).isNotNull();
            if (wanted.test(snapshot)) {
                return snapshot;
            }
        }
    }
}
