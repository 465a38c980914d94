package org.robonewbie.studio.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;

/**
 * A match of RCSSServerMJ 0.2.1, from its log: two T1, two K1 and two NAOs hold their stance and wave, and the left team kicks off.
 */
@Timeout(120)
class LeagueMatchTest {

    private static final String LOG = "rsmp_t1_k1_nao_kick_off.log.gz";

    @TempDir
    private Path folder;

    private static byte[] packed() throws IOException {
        return LeagueMatchTest.class.getResourceAsStream(LOG).readAllBytes();
    }

    private static byte[] plain() throws IOException {
        return new GZIPInputStream(new ByteArrayInputStream(packed())).readAllBytes();
    }

    private static List<String> messages() throws IOException {
        return new String(plain(), StandardCharsets.UTF_8).lines().toList();
    }

    private Optional<String> convert(byte[] log) throws IOException {
        return MonitorLogReader.convert(Files.write(folder.resolve("game.log"), log), folder.resolve("game.rec"));
    }

    private List<RecordedCycle> cycles(Path recording) throws IOException {
        List<RecordedCycle> cycles = new ArrayList<>();
        try (RecordingReader reader = RecordingFile.read(recording)) {
            for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
                cycles.add(cycle.get());
            }
        }
        return cycles;
    }

    private void assertMatch(List<RecordedCycle> cycles) {
        List<RobotSnapshot> robots = cycles.get(cycles.size() - 1).snapshot().robots();
        assertThat(robots)
                .extracting(robot -> robot.state().model().name())
                .containsExactly("T1", "T1", "K1", "K1", "nao0", "nao0");
        RobotState t1 = robots.get(0).state();
        int knee = BoosterT1.MODEL.joint("lle4").orElseThrow().index();
        assertThat(t1.degrees(knee)).isCloseTo(40, within(5.0));
        assertThat(t1.torso().position().z()).isCloseTo(0.64, within(0.02));
        RobotSnapshot nao = robots.get(4);
        int naoKnee = NaoModel.of(RobotType.TYPE_0).hingeIndex(Joint.LEFT_KNEE_PITCH);
        assertThat(nao.type()).isEqualTo(RobotType.TYPE_0);
        assertThat(nao.body().hingeDegrees(naoKnee)).isCloseTo(-40, within(5.0));
        assertThat(cycles.get(cycles.size() - 1).snapshot().playMode()).isEqualTo(PlayMode.KICK_OFF_LEFT);
        assertThat(cycles).anyMatch(cycle -> cycle.events().contains("playmode KickOff_Left"));
    }

    @Test
    void logBecomesARecordingWithItsRobots() throws IOException {
        assertThat(convert(plain())).isEmpty();

        List<RecordedCycle> cycles = cycles(folder.resolve("game.rec"));
        assertMatch(cycles);
        assertThat(cycles).hasSize(111);
    }

    @Test
    void logMayBePacked() throws IOException {
        assertThat(convert(packed())).isEmpty();

        assertMatch(cycles(folder.resolve("game.rec")));
    }

    @Test
    void matchesInOneLogFollowEachOther() throws IOException {
        String match = new String(plain(), StandardCharsets.UTF_8);

        assertThat(convert((match + match).getBytes(StandardCharsets.UTF_8))).isEmpty();

        List<RecordedCycle> cycles = cycles(folder.resolve("game.rec"));
        assertMatch(cycles);
        assertThat(cycles).hasSize(2 * 111 + 1);
        assertThat(cycles.get(112).events()).containsExactly("playmode BeforeKickOff");
        assertThat(cycles.get(110).snapshot().gameTime()).isEqualTo(0.18);
        assertThat(cycles.get(112).snapshot().gameTime()).isZero();
    }

    @Test
    void cutLogIsReadUpToTheCut() throws IOException {
        byte[] log = plain();

        assertThat(convert(Arrays.copyOf(log, log.length * 2 / 3)))
                .get()
                .asString()
                .contains("not understood: 1 of 36. Line 36: ");
        assertThat(cycles(folder.resolve("game.rec"))).hasSizeGreaterThan(50);
    }

    @Test
    void cutPackedLogIsReadUpToTheCut() throws IOException {
        byte[] log = packed();

        assertThat(convert(Arrays.copyOf(log, log.length * 2 / 3)))
                .get()
                .asString()
                .contains("the compressed file ends in the middle");
        assertThat(cycles(folder.resolve("game.rec"))).hasSizeGreaterThan(20);
    }

    @Test
    void logOfAnotherVersionIsRefused() throws IOException {
        byte[] log = new String(plain(), StandardCharsets.UTF_8)
                .replace("((RSMP 1 0)", "((RSMP 2 0)")
                .getBytes(StandardCharsets.UTF_8);

        assertThatThrownBy(() -> convert(log))
                .hasMessageContaining(
                        "is a log of RCSSServerMJ that cannot be read. Line 1: \"RSMP\" has version 2.0;");
    }

    @Test
    void observerWhoComesLateSeesTheLastScene() throws Exception {
        try (ScriptedMonitorPort server = new ScriptedMonitorPort(messages().subList(0, 1));
                MonitoredSimulation match = MonitoredSimulation.connect("127.0.0.1", server.number())) {
            CompletableFuture<WorldSnapshot> seen = new CompletableFuture<>();

            match.addObserver(new SimulationObserver() {
                @Override
                public void cycleEnded(WorldSnapshot snapshot) {
                    seen.complete(snapshot);
                }
            });

            assertThat(seen.get().robots()).isNotEmpty();
        }
    }

    @Test
    void watchedMatchIsRecordedWithItsRobots() throws Exception {
        Path recording = folder.resolve("watched.rec");
        try (ScriptedMonitorPort server = new ScriptedMonitorPort(messages());
                MonitoredSimulation match = MonitoredSimulation.connect(
                        "127.0.0.1", server.number(), OptionalInt.empty(), () -> Optional.of(recording))) {
            CountDownLatch kickOff = new CountDownLatch(1);
            match.addObserver(new SimulationObserver() {
                @Override
                public void cycleEnded(WorldSnapshot snapshot) {
                    if (snapshot.playMode() == PlayMode.KICK_OFF_LEFT) {
                        kickOff.countDown();
                    }
                }
            });
            match.order(new Order.KickOff(TeamSide.LEFT));
            assertThat(kickOff.await(60, TimeUnit.SECONDS)).isTrue();
        }

        assertMatch(cycles(recording));
    }

    @Test
    void ordersAreThoseOfTheServer() throws Exception {
        try (ScriptedMonitorPort server = new ScriptedMonitorPort(messages());
                MonitoredSimulation match = MonitoredSimulation.connect("127.0.0.1", server.number())) {
            assertThat(server.received.poll(60, TimeUnit.SECONDS)).isEqualTo("(reqfullstate)");

            match.order(new Order.KickOff(TeamSide.LEFT));
            match.order(new Order.DropBall());
            match.order(new Order.ChangePlayMode(PlayMode.GAME_OVER));
            match.order(new Order.MoveBall(new Vector3(1, 2, 0), Vector3.ZERO));
            match.order(new Order.PlaceRobot(new PlayerNumber(TeamSide.RIGHT, 3), new Vector3(2, 1, 0.7), 90));

            assertThat(match.hasClock()).isFalse();
            assertThat(match.canSetMatch()).isFalse();
            assertThat(match.field().length()).isEqualTo(55);
            assertThat(match.pitchDetails().ballRadius()).isEqualTo(0.11);
            assertThat(take(server, 4))
                    .containsExactly(
                            "(kickOff Left)",
                            "(dropBall)",
                            "(ball(pos 1 2 0.11)(vel 0 0 0))",
                            "(agent(unum 3)(team Right)(move 2 1 0.7 90))");
        }
    }

    private static List<String> take(ScriptedMonitorPort server, int count) throws InterruptedException {
        List<String> orders = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            orders.add(server.received.poll(60, TimeUnit.SECONDS));
        }
        return orders;
    }

    @Test
    void agentPortOfTheLeaguesServerIsNamed() throws IOException {
        try (ScriptedMonitorPort server = new ScriptedMonitorPort(List.of())) {
            assertThatThrownBy(() -> MonitoredSimulation.connect("127.0.0.1", server.number()))
                    .isInstanceOf(WrongPortException.class)
                    .hasMessageContaining("RCSSServerMJ")
                    .hasMessageContaining("usually 60001");
        }
    }

    @Test
    void agentPortOfSimSparkIsNamed() throws IOException {
        try (ScriptedMonitorPort server = new ScriptedMonitorPort(List.of("(time (now 12.3))(GS (t 0.00))"))) {
            assertThatThrownBy(() -> MonitoredSimulation.connect("127.0.0.1", server.number()))
                    .isInstanceOf(WrongPortException.class)
                    .hasMessage(
                            "127.0.0.1:" + server.number() + " is the agent port of a SimSpark server. It is watched at"
                                    + " its monitor port, which is usually 3200.");
        }
    }
}
