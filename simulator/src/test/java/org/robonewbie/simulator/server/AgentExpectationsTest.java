package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.TcpAgentLink;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;
import org.robonewbie.simulator.SimulationControl;

/** What the public agents of the league rely on in a server. */
@Timeout(60)
class AgentExpectationsTest {

    private static final String SCENE = "(scene rsg/agent/nao/nao.rsg)";

    private final WorldWatcher watcher = new WorldWatcher();
    private Simulator simulator;
    private TestAgent agent;

    @BeforeEach
    void startLeagueServer() throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.league()
                        .agentPort(0)
                        .synchronous(true)
                        .awaitedAgents(1)
                        .speed(SimulationControl.AS_FAST_AS_POSSIBLE)
                        .build(),
                new RecordingConsole());
        simulator.control().addObserver(watcher);
        agent = connect();
    }

    @AfterEach
    void close() throws IOException {
        agent.close();
        simulator.close();
    }

    @Test
    void messagesStartAfterSceneAndBeforeInit() throws IOException {
        PerceptorMessage message = agent.exchange(SCENE + "(syn)");

        assertThat(message.seconds()).isPresent();
        assertThat(message.gameState().orElseThrow().number()).isEmpty();
    }

    @Test
    void synIsAcceptedAloneAndBesideEverything() throws IOException {
        agent.send("(syn)");
        agent.send(SCENE + "(syn)");

        assertThat(agent.receive().seconds()).isPresent();
        assertThat(agent.exchange("(init (unum 1)(teamname Stars))(syn)").seconds())
                .isPresent();
    }

    @Test
    void timeGrowsByOneCycleWithEachMessage() throws IOException {
        double last = agent.join("Stars", 1).seconds().orElseThrow();

        for (int i = 0; i < 20; i++) {
            double now = agent.exchange("(syn)").seconds().orElseThrow();
            assertThat(now - last).isCloseTo(0.02, within(1e-9));
            last = now;
        }
    }

    @Test
    void timeGoesOnWhileTimeOfPlayStandsStill() throws IOException {
        PerceptorMessage first = agent.join("Stars", 1);

        PerceptorMessage second = agent.exchange("(syn)");

        assertThat(second.gameState().orElseThrow().playSeconds()).isZero();
        assertThat(second.seconds().orElseThrow()).isGreaterThan(first.seconds().orElseThrow());
    }

    @Test
    void numbersHaveTwoDecimalsAndNoExponent() throws IOException {
        agent.join("Stars", 1);

        for (int i = 0; i < 30; i++) {
            agent.send("(lae1 0.0000001)(syn)");
            String text = agent.receiveText().toString();
            assertThat(text).doesNotContainPattern("[0-9]e[-+0-9]");
            assertThat(text.replaceAll("[^0-9.()]", " ")).doesNotContainPattern("\\.[0-9]{3}|\\.[0-9](?![0-9])");
        }
    }

    @Test
    void visionThatShowsNothingKeepsItsBlank() throws IOException {
        agent.join("Stars", 1);
        agent.exchange("(beam -15 10 180)(syn)");
        simulator.control().placeRobot(TeamSide.LEFT, 1, new Vector3(-14.5, 9.5, 30), 180);
        StringBuilder heard = new StringBuilder();

        for (int i = 0; i < 6; i++) {
            agent.send("(he2 10)(syn)");
            heard.append(agent.receiveText());
        }

        assertThat(heard.toString()).contains("(See ").doesNotContain("(See)");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4})
    void everyRobotTypeCanBeCreated(int type) throws IOException {
        agent.send("(scene rsg/agent/nao/nao_hetero.rsg " + type + ")(syn)");

        String message = agent.receiveText().toString();

        assertThat(message.contains("(HJ (n llj7)")).isEqualTo(type == 4);
        assertThat(message.contains("(HJ (n rlj7)")).isEqualTo(type == 4);
        assertThat(watcher.latest().robots().get(0).type().ordinal()).isEqualTo(type);
    }

    @Test
    void toesOfTypeFourMoveAndFeel() throws IOException {
        agent.send("(scene rsg/agent/nao/nao_hetero.rsg 4)(syn)");
        agent.receiveText();
        agent.exchange("(init (unum 1)(teamname Stars))(syn)");
        PerceptorMessage message = agent.exchange("(syn)");
        for (int i = 0; i < 40; i++) {
            message = agent.exchange("(syn)");
        }

        assertThat(message.footForces().left()).isPresent();
        assertThat(message.footForces().leftToe()).isPresent();
    }

    @Test
    void beamIsSwallowedWhileTheGameRuns() throws IOException {
        agent.join("Stars", 1);
        agent.exchange("(beam -3 0 0)(syn)");
        simulator.control().setPlayMode(PlayMode.PLAY_ON);
        cycles(3);

        agent.exchange("(beam -9 5 0)(syn)");
        cycles(3);

        assertThat(torsoX(0)).isCloseTo(-3, within(0.2));
    }

    @Test
    void beamIsMirroredForTheRightTeam() throws IOException {
        agent.join("Stars", 1);
        keepAnswering(agent);
        try (TestAgent right = connect()) {
            right.join("Moons", 1);

            right.exchange("(beam -3 1 0)(syn)");
            right.exchange("(syn)");

            assertThat(torsoX(1)).isCloseTo(3, within(0.06));
        }
    }

    @Test
    void agentSeesItsOwnArms() throws IOException {
        agent.join("Stars", 1);
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
        assertThat(seen.get(0).parts()).hasSize(2);
    }

    @Test
    void visionComesInEachThirdMessage() throws IOException {
        agent.join("Stars", 1);
        StringBuilder pattern = new StringBuilder();

        for (int i = 0; i < 12; i++) {
            pattern.append(agent.exchange("(syn)").vision().isPresent() ? 'S' : '-');
        }

        assertThat(pattern.toString()).matches("(S--){4}|(-S-){4}|(--S){4}");
    }

    @Test
    void goalIsFollowedByKickOffAndDropBall() throws IOException {
        agent.join("Stars", 1);
        simulator.control().setPlayMode(PlayMode.PLAY_ON);
        simulator.control().placeBall(new Vector3(14.9, 0, 0.042), new Vector3(4, 0, 0));

        PlayMode afterGoal = cycles(20);
        PlayMode afterPause = cycles(150);
        PlayMode afterTimeout = cycles(15 * 50 + 10);

        assertThat(afterGoal).isEqualTo(PlayMode.GOAL_LEFT);
        assertThat(afterPause).isEqualTo(PlayMode.KICK_OFF_RIGHT);
        assertThat(afterTimeout).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void heardMessageNamesTeamTimeAndDirection() throws IOException {
        agent.join("Stars", 1);

        agent.send("(say hello)(syn)");
        String first = agent.receiveText().toString();
        agent.send("(syn)");
        String second = agent.receiveText().toString();

        assertThat(first + second).contains("(hear Stars 0.00 self hello)");
    }

    private TestAgent connect() throws IOException {
        return new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()));
    }

    private PlayMode cycles(int count) throws IOException {
        PlayMode mode = PlayMode.BEFORE_KICK_OFF;
        for (int i = 0; i < count; i++) {
            mode = agent.exchange("(syn)").gameState().orElseThrow().playMode().orElseThrow();
        }
        return mode;
    }

    private static void keepAnswering(TestAgent agent) {
        Thread thread = new Thread(() -> {
            try {
                while (true) {
                    agent.exchange("(syn)");
                }
            } catch (IOException e) {
                // The simulator has ended.
            }
        });
        thread.setDaemon(true);
        thread.start();
    }

    private double torsoX(int robot) {
        return watcher.latest().robots().get(robot).linkPoses()[0];
    }
}
