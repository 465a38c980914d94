package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;
import org.robonewbie.protocol.tcp.MonitorLink;

/** What all public agents of the league rely on in a server, one test for each thing. */
@Timeout(120)
class AllAgentsExpectationsTest {

    private static final String SCENE = "(scene rsg/agent/nao/nao.rsg)";

    @AutoClose
    private final LeagueServer server = new LeagueServer();

    AllAgentsExpectationsTest() throws IOException {}

    @Test
    void messagesStartRightAfterSceneAndBeforeInitAndNotBeforeScene() throws IOException {
        try (LeagueServer running = new LeagueServer(false);
                Socket quiet = new Socket(InetAddress.getLoopbackAddress(), running.simulator.agentPort())) {
            TestAgent other = running.connect();
            other.joinRunningGame("Stars", 1);
            LeagueServer.cycles(other, 100);

            assertThat(quiet.getInputStream().available()).isZero();

            quiet.getOutputStream().write(new byte[] {0, 0, 0, (byte) SCENE.length()});
            quiet.getOutputStream().write(SCENE.getBytes(StandardCharsets.US_ASCII));
            byte[] beginning = quiet.getInputStream().readNBytes(15);
            assertThat(new String(beginning, 4, 11, StandardCharsets.US_ASCII)).isEqualTo("(time (now ");
        }
    }

    @Test
    void numberAndSideComeOnceWithinTheFirstFourMessagesAfterInit() throws IOException {
        TestAgent agent = server.connect();
        agent.exchange(SCENE + "(syn)");
        List<Optional<TeamSide>> sides = new ArrayList<>();

        agent.send("(init (unum 3)(teamname Stars))(syn)");
        for (int i = 0; i < 20; i++) {
            GameState state = agent.receive().gameState().orElseThrow();
            assertThat(state.number().isPresent()).isEqualTo(state.side().isPresent());
            sides.add(state.side());
            agent.send("(syn)");
        }

        assertThat(sides.subList(0, 4)).contains(Optional.of(TeamSide.LEFT));
        assertThat(sides).filteredOn(Optional::isPresent).hasSize(1);
    }

    @Test
    void oneMessageComesInEachCycleAndNoTwoAreEqual() throws IOException {
        TestAgent agent = server.join("Stars", 1);
        String lastText = "";
        double last = agent.exchange("(syn)").seconds().orElseThrow();

        for (int i = 0; i < 100; i++) {
            agent.send("(syn)");
            String text = agent.receiveText().toString();
            double now = Double.parseDouble(text.substring("(time (now ".length(), text.indexOf(')')));
            assertThat(now - last).isCloseTo(0.02, within(1e-9));
            assertThat(text).isNotEqualTo(lastText);
            last = now;
            lastText = text;
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void synIsAcceptedAloneBesideSceneAndBesideInitWhetherTheWorldWaitsOrNot(boolean waits) throws IOException {
        try (LeagueServer either = new LeagueServer(waits)) {
            TestAgent agent = either.connect();
            agent.send("(syn)");
            assertThat(agent.exchange(SCENE + "(syn)").seconds()).isPresent();
            assertThat(agent.exchange("(init (unum 1)(teamname Stars))(syn)").seconds())
                    .isPresent();
            assertThat(agent.exchange("(syn)").seconds()).isPresent();

            assertThat(either.console.sentences()).isEmpty();
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0.385", "1, 0.42164", "2, 0.385", "3, 0.440737", "4, 0.385"})
    void eachRobotTypeHasItsOwnLegsAndOnlyTypeFourHasToes(int type, double height) throws IOException {
        TestAgent agent = server.connect();
        agent.exchange("(scene rsg/agent/nao/nao_hetero.rsg " + type + ")(syn)");
        agent.exchange("(init (unum 2)(teamname Stars))(syn)");
        agent.exchange("(syn)");
        agent.exchange("(beam -5 0 0)(syn)");
        LeagueServer.cycles(agent, 150);
        agent.send("(lle7 1)(rle7 1)(syn)");

        String text = agent.receiveText().toString();

        assertThat(server.torso(0, 2)).isCloseTo(height, within(0.004));
        assertThat(NaoModel.of(RobotType.values()[type]).links().stream()
                        .mapToDouble(link -> link.massKg())
                        .sum())
                .isCloseTo(4.6071, within(0.0001));
        for (String word : List.of("(HJ (n llj7)", "(HJ (n rlj7)", "(FRP (n lf1)", "(FRP (n rf1)")) {
            assertThat(text.contains(word)).as(word).isEqualTo(type == 4);
        }
    }

    @Test
    void beamWorksBeforeKickOffAndAfterGoalsOnlyAndMayBeRepeated() throws IOException {
        TestAgent agent = server.join("Stars", 1);
        LeagueServer.cyclesOfAll(5, "(beam -3 0 0)(syn)", agent);
        assertThat(server.torso(0, 0)).isCloseTo(-3, within(0.06));

        server.control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        LeagueServer.cycles(agent, 3);
        LeagueServer.cyclesOfAll(5, "(beam -9 5 0)(syn)", agent);
        assertThat(server.torso(0, 0)).isCloseTo(-3, within(0.2));

        server.control().order(new Order.ChangePlayMode(PlayMode.BEFORE_KICK_OFF));
        LeagueServer.cyclesOfAll(500, "(beam -9 5 0)(syn)", agent);
        assertThat(server.torso(0, 0)).isCloseTo(-9, within(0.06));
        assertThat(server.torso(0, 2)).isBetween(0.38, 0.41);

        server.control().order(new Order.ChangePlayMode(PlayMode.GOAL_RIGHT));
        LeagueServer.cyclesOfAll(5, "(beam -9 5 0)(syn)", agent);
        assertThat(server.torso(0, 0)).isCloseTo(-9, within(0.06));
        assertThat(server.torso(0, 1)).isCloseTo(5, within(0.06));
    }

    @Test
    void beamIsMirroredForTheRightTeam() throws IOException {
        try (LeagueServer running = new LeagueServer(false)) {
            TestAgent left = running.connect();
            left.joinRunningGame("Stars", 1);
            TestAgent right = running.connect();
            right.joinRunningGame("Moons", 1);

            do {
                LeagueServer.cyclesOfAll(1, "(beam -3 1 0)", left, right);
            } while (Math.abs(running.torso(0, 0) + 3) > 0.1 || Math.abs(running.torso(1, 0) - 3) > 0.1);

            assertThat(running.torso(0, 1)).isCloseTo(1, within(0.1));
            assertThat(running.torso(1, 1)).isCloseTo(-1, within(0.1));
        }
    }

    @Test
    void agentSeesItsOwnArms() throws IOException {
        TestAgent agent = server.join("Stars", 1);
        List<SeenPlayer> seen = List.of();
        for (int i = 0; i < 3 && seen.isEmpty(); i++) {
            seen = agent.exchange("(syn)")
                    .vision()
                    .map(vision -> vision.players())
                    .orElse(List.of());
        }

        assertThat(seen).hasSize(1);
        assertThat(seen.get(0).team()).isEqualTo("Stars");
        assertThat(seen.get(0).number()).isEqualTo(1);
        assertThat(seen.get(0).parts())
                .extracting(part -> part.part().simSparkName())
                .containsExactly("rlowerarm", "llowerarm");
    }

    @Test
    void nameOfATeamStaysReservedAndAVanishedClientIsRemoved() throws IOException {
        try (LeagueServer running = new LeagueServer(false);
                MonitorLink monitor = running.monitor()) {
            TestAgent moon = running.connect();
            moon.joinRunningGame("Stars", 1);
            try (TestAgent leaving = running.connect()) {
                leaving.joinRunningGame("Moons", 1);
                awaitRobots(monitor, 2);
            }
            awaitRobots(monitor, 1);
            assertThat(monitor.lastMessage().toString()).contains("(RSG 0 1)");

            GameState third =
                    running.connect().joinInVain("Suns", 1).gameState().orElseThrow();
            GameState again =
                    running.connect().joinRunningGame("Moons", 1).gameState().orElseThrow();

            assertThat(third.number()).isEmpty();
            assertThat(third.side()).isEmpty();
            assertThat(again.side()).contains(TeamSide.RIGHT);
        }
    }

    @Test
    void goalIsFollowedByKickOffAndDropBall() throws IOException {
        TestAgent agent = server.join("Stars", 1);
        server.control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        server.control().order(new Order.MoveBall(new Vector3(14.9, 0, 0.042), new Vector3(4, 0, 0)));

        assertThat(LeagueServer.cycles(agent, 20)).isEqualTo(PlayMode.GOAL_LEFT);
        assertThat(LeagueServer.cycles(agent, 130)).isEqualTo(PlayMode.GOAL_LEFT);
        assertThat(LeagueServer.cycles(agent, 10)).isEqualTo(PlayMode.KICK_OFF_RIGHT);
        assertThat(LeagueServer.cycles(agent, 15 * 50 - 15)).isEqualTo(PlayMode.KICK_OFF_RIGHT);
        assertThat(LeagueServer.cycles(agent, 20)).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void secondHalfWaitsForItsKickOffAfterThreeHundredSeconds() throws IOException {
        TestAgent agent = server.join("Stars", 1);
        try (MonitorLink trainer = server.monitor()) {
            trainer.send(new Order.ChangePlayMode(PlayMode.PLAY_ON), new Order.SetTime(299.5));
            PerceptorMessage message = agent.exchange("(syn)");
            while (message.gameState().orElseThrow().playSeconds() < 299.9) {
                message = agent.exchange("(syn)");
            }

            PlayMode mode = LeagueServer.cycles(agent, 50);

            assertThat(mode).isEqualTo(PlayMode.BEFORE_KICK_OFF);
            assertThat(server.watcher.latest().half()).isEqualTo(2);
            assertThat(server.watcher.latest().gameTime()).isCloseTo(300, within(1e-6));
        }
    }

    private static void awaitRobots(MonitorLink monitor, int count) throws IOException {
        do {
            assertThat(monitor.receive()).isTrue();
        } while (monitor.world().robots().size() != count
                || !monitor.lastMessage().toString().contains("(RSG"));
    }
}
