package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;

/**
 * What the benchmark tool magmaChallenge needs of a server. That it finds and ends the server by the name of its process, and
 * that the server understands its start script, is tested with the command line.
 */
@Timeout(120)
class MagmaChallengeExpectationsTest {

    private static final String BEAM = "(beam -3 2 0)";

    @Test
    void emptySceneHasThirtySixNodesInTheOrderOfTheOriginalAndTheBallLast() throws IOException {
        try (MonitoredSimulator match = new MonitoredSimulator()) {
            match.awaitFullMessage();

            List<String> kinds = new ArrayList<>();
            match.world().scene().forEach(node -> kinds.add(node.toString()));
            assertThat(kinds).hasSize(36);
            String text = match.monitor().lastMessage().toString();
            List<String> contents = Pattern.compile("nd Light|load [A-Za-z/.]+")
                    .matcher(text.substring(text.indexOf("RSG")))
                    .results()
                    .map(MatchResult::group)
                    .toList();
            assertThat(contents)
                    .containsExactly(
                            "nd Light",
                            "nd Light",
                            "load models/naosoccerfield.obj",
                            "load models/skybox.obj",
                            "load models/leftsoccergoal.obj",
                            "load models/rightsoccergoal.obj",
                            "load StdUnitBox",
                            "load StdUnitBox",
                            "load StdUnitBox",
                            "load StdUnitBox",
                            "load models/soccerball.obj");
            assertThat(match.world().ball().orElseThrow())
                    .isSameAs(match.world().scene().get(35));
            assertThat(match.world().ball().orElseThrow().position().z()).isCloseTo(0.042, within(0.002));
        }
    }

    @Test
    void robotsComeBehindTheBallWithTheMeshesOfHeadAndLimbs() throws IOException {
        try (MonitoredSimulator match = new MonitoredSimulator()) {
            match.join("us", 1);
            match.order(new Order.RequestFullState());

            String text = match.awaitFullMessage();

            assertThat(match.world().scene()).hasSize(37);
            String robot = text.substring(text.indexOf("soccerball"));
            for (String mesh : List.of(
                    "naobody0",
                    "naohead",
                    "rupperarm0",
                    "lupperarm0",
                    "rlowerarm",
                    "llowerarm",
                    "rthigh",
                    "lthigh",
                    "rshank0",
                    "lshank0",
                    "rfoot",
                    "lfoot")) {
                assertThat(robot).containsOnlyOnce("models/" + mesh + ".obj");
            }
        }
    }

    @Test
    void playModesComeInTheOrderThatTheToolKnowsByNumber() throws IOException {
        try (MonitoredSimulator match = new MonitoredSimulator()) {
            assertThat(match.awaitFullMessage())
                    .contains("(play_modes BeforeKickOff KickOff_Left KickOff_Right PlayOn KickIn_Left KickIn_Right"
                            + " corner_kick_left corner_kick_right goal_kick_left goal_kick_right offside_left"
                            + " offside_right GameOver Goal_Left Goal_Right free_kick_left free_kick_right"
                            + " direct_free_kick_left direct_free_kick_right pass_left pass_right)");
        }
    }

    @Test
    void beamBehindEachMessageOfAnAgentDoesNoHarmAndWorksOnceItHasJoined() throws IOException {
        try (LeagueServer server = new LeagueServer()) {
            TestAgent agent = server.connect();
            agent.send("(syn)" + BEAM);
            agent.exchange("(scene rsg/agent/nao/nao.rsg)(syn)" + BEAM);
            agent.exchange("(syn)" + BEAM);
            agent.exchange("(init (unum 2)(teamname Stars))(syn)" + BEAM);
            LeagueServer.cyclesOfAll(5, "(he1 0.1)(syn)" + BEAM, agent);

            assertThat(server.torso(0, 0)).isCloseTo(-3, within(0.06));
            assertThat(server.torso(0, 1)).isCloseTo(2, within(0.06));
        }
    }

    @Test
    void standingRobotFeelsBothFeetInEachMessage() throws IOException {
        try (LeagueServer server = new LeagueServer()) {
            TestAgent agent = server.join("Stars", 2);
            agent.exchange(BEAM + "(syn)");
            LeagueServer.cycles(agent, 100);

            Set<String> feet = new TreeSet<>();
            for (int i = 0; i < 50; i++) {
                agent.send("(syn)");
                String text = agent.receiveText().toString();
                feet.add(text.contains("(FRP (n lf)") + " " + text.contains("(FRP (n rf)"));
            }

            assertThat(feet).containsExactly("true true");
        }
    }

    @Test
    void trainerPutsTheBallAtRestToTheGround() throws IOException {
        try (MonitoredSimulator match = new MonitoredSimulator()) {
            match.order(new Order.MoveBall(Optional.of(new Vector3(4, 1, 0.042)), Optional.of(Vector3.ZERO)));

            match.await(seen -> seen.ball().orElseThrow().position().distanceTo(new Vector3(4, 1, 0.042)) < 0.01);
        }
    }
}
