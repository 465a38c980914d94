package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;

/** What the monitor RoboViz needs of a server; its way of reading is that of {@link RoboVizReader}. */
@Timeout(120)
class RoboVizExpectationsTest {

    /** The models that RoboViz has, as far as a NAO and the pitch need them. */
    private static final Set<String> MODELS = Set.of(
            "naosoccerfield",
            "skybox",
            "leftsoccergoal",
            "rightsoccergoal",
            "soccerball",
            "naobody0",
            "naobody1",
            "naobody2",
            "naobody3",
            "naobody4",
            "naohead",
            "rupperarm0",
            "rupperarm1",
            "rupperarm2",
            "rupperarm3",
            "rupperarm4",
            "lupperarm0",
            "lupperarm1",
            "lupperarm2",
            "lupperarm3",
            "lupperarm4",
            "rlowerarm",
            "llowerarm",
            "rthigh",
            "lthigh",
            "rshank0",
            "rshank1",
            "rshank2",
            "rshank3",
            "rshank4",
            "lshank0",
            "lshank1",
            "lshank2",
            "lshank3",
            "lshank4",
            "rfoot",
            "lfoot");

    private final RoboVizReader roboViz = new RoboVizReader();

    @SuppressWarnings("NullAway.Init")
    private MonitoredSimulator match;

    @BeforeEach
    void start() throws IOException {
        match = new MonitoredSimulator();
        match.setReader(roboViz::read);
    }

    @AfterEach
    void close() throws IOException {
        match.close();
    }

    @Test
    void fullStateComesUnaskedWithTheEnvironmentOfTheOriginal() throws IOException {
        watch(1);

        assertThat(match.monitor().lastMessage().toString())
                .startsWith("((FieldLength 30)(FieldWidth 20)(FieldHeight 40)(GoalWidth 2.1)(GoalDepth 0.6)"
                        + "(GoalHeight 0.8)(BorderSize 0)(FreeKickDistance 2)(WaitBeforeKickOff 30)(AgentRadius 0.4)"
                        + "(BallRadius 0.042)(BallMass 0.026)(RuleGoalPauseTime 3)(RuleKickInPauseTime 1)"
                        + "(RuleHalfTime 300)(PassModeMinOppBallDist 1)(PassModeDuration 4)(play_modes BeforeKickOff ")
                .contains("(time 0)(half 1)(score_left 0)(score_right 0)(play_mode 0))(RSG 0 1)(");
        assertThat(roboViz.fullMessages()).isEqualTo(1);
    }

    @Test
    void eachFrameOfALivelyGameIsReadableWithItsFirstListFilledAndItsNodesInStep() throws IOException {
        watch(5);
        TestAgent first = match.join("us", 1);
        TestAgent second = match.join("them", 10);
        match.order(new Order.RequestFullState());
        watch(100);
        match.simulator().control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        match.simulator().control().order(new Order.MoveBall(new Vector3(14.9, 0, 0.042), new Vector3(4, 0, 0)));
        watch(100);
        first.close();
        watch(50);
        second.close();
        match.order(new Order.SelectNextRobot(), new Order.RequestFullState());
        watchUntil(() -> roboViz.nodes().size() == 36);

        assertThat(roboViz.fullMessages()).isGreaterThanOrEqualTo(4);
        assertThat(roboViz.value("score_left")).isEqualTo("1");
    }

    @Test
    void robotsAreFoundByNumberAndTeamOnOneMeshBelowOneNodeEach() throws IOException {
        match.join("us", 1);
        match.join("them", 10);
        match.order(new Order.RequestFullState());

        watchUntil(() ->
                roboViz.nodes().size() == 38 && !roboViz.value("team_right").isEmpty());

        assertThat(materials(roboViz.nodes().get(36)))
                .anyMatch(mesh -> mesh.containsAll(List.of("matNum1", "matLeft")));
        assertThat(materials(roboViz.nodes().get(37)))
                .anyMatch(mesh -> mesh.containsAll(List.of("matNum10", "matRight")));
        for (RoboVizReader.Node node : roboViz.nodes().subList(0, 36)) {
            assertThat(materials(node).toString()).doesNotContain("matNum");
        }
    }

    @Test
    void modelsAreNamedLikeRoboVizsOwnFiles() throws IOException {
        for (int type = 0; type < 5; type++) {
            TestAgent agent = new TestAgent(match.simulator().connect());
            agent.exchange("(scene rsg/agent/nao/nao_hetero.rsg " + type + ")(syn)");
        }
        match.order(new Order.RequestFullState());
        watchUntil(() -> roboViz.nodes().size() == 41);

        List<String> models = new ArrayList<>();
        roboViz.nodes().forEach(node -> collect(node, "load", models));

        assertThat(models.stream().filter(model -> model.startsWith("models/")))
                .hasSizeGreaterThan(50)
                .allMatch(model -> MODELS.contains(model.replaceAll("models/(.*)\\.obj", "$1")));
    }

    @Test
    void invisibleIsOnlyTheMarkOfASelectedRobot() throws IOException {
        match.join("us", 1);
        match.order(new Order.RequestFullState());
        watchUntil(() -> roboViz.nodes().size() == 37);

        List<String> visible = new ArrayList<>();
        roboViz.nodes().forEach(node -> collect(node, "setVisible", visible));

        assertThat(visible).containsOnlyOnce("0").contains("1");
    }

    @Test
    void foulsAreToldOnceWithNumberKindTeamAndPlayer() throws IOException {
        TestAgent agent = match.join("us", 5);
        match.simulator().control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        agent.send("(rae1 -1.4)(rae2 1)(rae3 -1)(rae4 1.5)(syn)");

        watchUntil(() -> !roboViz.fouls().isEmpty());

        assertThat(roboViz.fouls().get(0)).containsExactly("1", "7", "1", "5");
    }

    @Test
    void timeWithoutGoalsAfterAPassIsTold() throws IOException {
        TestAgent agent = match.join("us", 5);
        match.simulator().control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        match.simulator()
                .control()
                .order(new Order.PlaceRobot(new PlayerNumber(TeamSide.LEFT, 5), new Vector3(-0.4, 0, 0.4), 0));
        watchUntil(() -> {
            sendPass(agent);
            return roboViz.value("play_mode").equals("19");
        });

        watchUntil(() -> !roboViz.value("pass_mode_score_wait_left").isEmpty());

        assertThat(Double.parseDouble(roboViz.value("pass_mode_score_wait_left")))
                .isBetween(9.0, 10.0);
    }

    @Test
    void agentThatHasNoRobotYetDoesNotAppear() throws IOException {
        watch(1);
        try (TestAgent agent = new TestAgent(match.simulator().connect())) {
            agent.send("(syn)");
            match.order(new Order.RequestFullState());
            watchUntil(() -> roboViz.fullMessages() == 2);

            assertThat(roboViz.nodes()).hasSize(36);
        }
    }

    private static void sendPass(TestAgent agent) {
        try {
            agent.send("(pass)(syn)");
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private void watch(int messages) throws IOException {
        for (int i = 0; i < messages; i++) {
            match.receive();
        }
    }

    private void watchUntil(BooleanSupplier wanted) throws IOException {
        for (int i = 0; i < 1000 && !wanted.getAsBoolean(); i++) {
            watch(1);
        }
        assertThat(wanted.getAsBoolean()).isTrue();
    }

    private static List<List<String>> materials(RoboVizReader.Node node) {
        List<List<String>> materials = new ArrayList<>();
        if (node.name.equals("resetMaterials")) {
            materials.add(node.words);
        }
        node.children.forEach(child -> materials.addAll(materials(child)));
        return materials;
    }

    private static void collect(RoboVizReader.Node node, String name, List<String> firstWords) {
        if (node.name.equals(name)) {
            firstWords.add(node.words.get(0));
        }
        node.children.forEach(child -> collect(child, name, firstWords));
    }
}
