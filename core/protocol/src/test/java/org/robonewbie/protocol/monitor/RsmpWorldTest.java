package org.robonewbie.protocol.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.within;
import static org.robonewbie.protocol.monitor.RecordedMonitorMessages.message;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotState;

class RsmpWorldTest {

    private static final String UNTURNED = "1 0 0 0 0 1 0 0 0 0 1 0 ";

    /** A rotation by 90° about z. */
    private static final String TURNED_LEFT = "0 1 0 0 -1 0 0 0 0 0 1 0 ";

    private static final String GAME = "((gs 1 0)(time 0)(half 1)(score_left 0)(score_right 0)(play_mode 0)"
            + "(team_left Blue)(team_right <RIGHT>))((ge 1 0)(FieldLength 55)(play_modes BeforeKickOff PlayOn X))";

    /** A pendulum of the left team: a box, and below it a body with a sphere at its end. */
    private static final String PENDULUM = "(nd DSC(agent Blue 7)(nd TRF(SLT " + UNTURNED + "3 2 1 1)"
            + "(nd SMN(load StdUnitBox)(sSc 0.2 0.3 0.4))"
            + "(nd TRF(SLT " + UNTURNED + "0 0 -0.2 1)"
            + "(nd TRF(SLT " + UNTURNED + "0 0 -0.5 1)(nd SMN(load StdUnitSphere)(sSc 0.1 0.1 0.1))))))";

    private static final PlayerNumber PLAYER = new PlayerNumber(TeamSide.LEFT, 7);

    private final RsmpWorld world = new RsmpWorld();

    @Test
    void nothingIsKnownBeforeTheFirstMessage() {
        assertThat(world.isCurrent()).isFalse();
        assertThat(world.robots()).isEmpty();
        assertThat(world.ball()).isEmpty();
        assertThat(world.problem()).isEmpty();
        assertThat(world.gameState()).isEqualTo(MonitoredGame.UNKNOWN);
    }

    @Test
    void firstMessageChoosesTheLanguage() {
        MonitoredWorld either = new MonitoredWorld();

        assertThat(either.read(message(full("")))).isTrue();
        assertThat(either.rsmp()).isPresent();
        assertThat(either.environment().measure("FieldLength")).hasValue(55);
        assertThat(either.gameState().teamLeft()).contains("Blue");

        MonitoredWorld simSpark = new MonitoredWorld();
        simSpark.read(message(
                RecordedMonitorMessages.load(RecordedMonitorMessages.SIMSPARK).get(0)));
        assertThat(simSpark.rsmp()).isEmpty();
        assertThat(simSpark.read(message(full("")))).isFalse();
        assertThat(simSpark.rsmp()).isEmpty();
    }

    @Test
    void changesBeforeTheFirstFullMessageAreNotEnough() {
        assertThat(world.read(message("((RSMP 1 0)((gt 1 0)2.5)((sg 1 0)diff(nd))((gs 1 0)(time 2)))")))
                .isFalse();

        assertThat(world.problem()).isEmpty();
        assertThat(world.gameState().timeSeconds()).isEqualTo(2);
        assertThat(world.seconds()).isEqualTo(2.5);
    }

    @Test
    void nestedTransformsAreComposed() {
        world.read(message("((RSMP 1 0)((sg 1 0)full(nd TRF(SLT " + TURNED_LEFT + "10 0 0 1)(nd TRF(SLT " + UNTURNED
                + "1 2 0 1)(nd DSC(ball)(nd TRF(SLT " + UNTURNED + "0.5 0 0.11 1)))))))"));

        assertThat(world.problem()).isEmpty();
        Vector3 ball = world.ball().orElseThrow().position();
        assertThat(ball.minus(new Vector3(8, 1.5, 0.11)).length()).isCloseTo(0, within(1e-9));
    }

    @Test
    void robotThatIsNotShippedIsMadeOfItsShapes() {
        world.read(message(full(PENDULUM)));

        assertThat(world.problem()).isEmpty();
        RsmpRobot robot = world.robots().get(0);
        assertThat(robot.player()).isEqualTo(PLAYER);
        RobotModel model = robot.state().model();
        assertThat(model.name()).isEqualTo("robot");
        assertThat(model.joints()).extracting("name").containsExactly("1x", "1y", "1z");
        assertThat(model.bodies().get(0).shapes().get(0).shape()).isInstanceOf(Shape.Box.class);
        assertThat(model.bodies().get(3).shapes().get(0).shape()).isEqualTo(new Shape.Sphere(0.1f));
        assertThat(robot.state().torso().position()).isEqualTo(new Vector3(3, 2, 1));
    }

    @ParameterizedTest
    @CsvSource({
        "1 0 0 0 0 0.8 0.6 0 0 -0.6 0.8 0, 36.87, 0, 0",
        "0.8 0 -0.6 0 0 1 0 0 0.6 0 0.8 0, 0, 36.87, 0",
        "0.8 0.6 0 0 -0.6 0.8 0 0 0 0 1 0, 0, 0, 36.87",
    })
    void changesTurnTheJointsOfThatRobot(String rotation, double x, double y, double z) {
        world.read(message(full(PENDULUM)));
        world.read(message(changes("(nd(nd(nd)(nd TRF(SLT " + rotation + " 0 0 -0.2 1)(nd(nd)))))")));

        assertThat(world.problem()).isEmpty();
        RobotState state = world.robots().get(0).state();
        assertThat(state.degrees(0)).isCloseTo(x, within(0.01));
        assertThat(state.degrees(1)).isCloseTo(y, within(0.01));
        assertThat(state.degrees(2)).isCloseTo(z, within(0.01));
    }

    @Test
    void robotKeepsItsModelInTheNextFullMessage() {
        world.read(message(full(PENDULUM)));
        RobotModel first = world.robots().get(0).state().model();

        world.read(message(full(PENDULUM.replace(UNTURNED + "0 0 -0.2", TURNED_LEFT + "0 0 -0.2"))));

        RobotState state = world.robots().get(0).state();
        assertThat(state.model()).isSameAs(first);
        assertThat(state.degrees(2)).isCloseTo(90, within(1e-6));
    }

    @Test
    void teamsAndPlayModesAreUnderstood() {
        world.read(message(full("")));

        assertThat(world.gameState().playMode()).contains(PlayMode.BEFORE_KICK_OFF);
        assertThat(world.gameState().teamRight()).isEmpty();
        world.read(message("((RSMP 1 0)((gs 1 0)(play_mode 1)(score_left 2)(foul 10 1 7)(foul 4 2 3)))"));
        assertThat(world.gameState().playMode()).contains(PlayMode.PLAY_ON);
        assertThat(world.gameState().scoreLeft()).isEqualTo(2);
        assertThat(world.newFouls())
                .containsExactly(
                        new Foul(1, FoulType.HAND_FOUL, PLAYER),
                        new Foul(2, FoulType.INCAPABLE, new PlayerNumber(TeamSide.RIGHT, 3)));
        world.read(message("((RSMP 1 0)((gs 1 0)(play_mode 2)))"));
        assertThat(world.gameState().playMode()).isEmpty();
        assertThat(world.newFouls()).isEmpty();
    }

    @Test
    void whatNewerServersAddIsSkipped() {
        assertThat(world.read(message(
                        "((RSMP 1 3)((xy 2 0)(a b))((sg 1 1)full" + tree("") + ")((gs 1 9)(x (y z))(time 3)))")))
                .isTrue();

        assertThat(world.gameState().timeSeconds()).isEqualTo(3);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    ((RSMP 2 0)((gt 1 0)1))               | "RSMP" has version 2.0; this version of RoboNewbie reads version 1.0
                    ((RSMP 1 0)((sg 2 1)full(nd TRF)))    | "sg" has version 2.1; this version of RoboNewbie reads version 1.0
                    ((RSMP one 0))                        | expected the version of "RSMP", a number, found "one"
                    ((RSMP 1 0)((gt 1 0)soon))            | expected the time, a number, found "soon"
                    ((RSMP 1 0)((gt 1 0)nan))             | expected the time, a number, found "nan"
                    ((RSMP 1 0)((gt 1 0)1e300))           | expected the time, a number, found "1e300"
                    ((RSMP 1 0)((gt 1 0)1                 | expected ")", found the end of the message
                    ((RSMP 1 0)) more                     | expected the end of the message, found "more"
                    ((RSMP 1 0)((sg 1 0)half(nd TRF)))    | expected "full" or "diff", found "half"
                    ((RSMP 1 0)((sg 1 0)full(nd XYZ)))    | expected "DSC", "TRF" or "SMN", found "XYZ"
                    ((RSMP 1 0)((sg 1 0)full(nd TRF)))    | a node "TRF" has no "SLT"
                    ((RSMP 1 0)((sg 1 0)full(nd TRF(SLT 1 2 x)))) | expected element 3 of 16 of "SLT", a number, found "x"
                    ((RSMP 1 0)((sg 1 0)full(nd TRF(SLT 1 2))))   | expected element 3 of 16 of "SLT", a number, found ")"
                    ((RSMP 1 0)((sg 1 0)full(nd TRF(SLT 2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1)))) | the first elements of "SLT" are no rotation
                    ((RSMP 1 0)((gs 1 0)(half 3)))        | expected the half, a whole number from 1 to 2, found "3"
                    ((RSMP 1 0)((gs 1 0)(score_left -1))) | expected a score, a whole number from 0 to 255, found "-1"
                    ((RSMP 1 0)((gs 1 0)(foul 1 3 1)))    | expected the side of a foul, a whole number from 1 to 2, found "3"
                    ((RSMP 1 0)((ge 1 0)(FieldLength)))   | expected "FieldLength", a number, found ")"
                    """)
    void refusalNamesMessageAndWord(String text, String reason) {
        world.read(message("((RSMP 1 0))"));

        assertThat(world.read(message(text))).isFalse();
        assertThat(problem()).isEqualTo("Message 2: " + reason + ".");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    (nd DSC(agent Blue 1))                | "agent Blue 1" describes 0 bodies instead of one
                    (nd DSC(agent Green 1)BODY)           | the agent's team "Green" plays on neither side
                    (nd DSC(agent Blue x)BODY)            | expected the number of an agent, found "x"
                    (nd DSC(agent Blue)BODY)              | expected "agent TEAM NUMBER", found "agent Blue"
                    (nd SMN(setVisible 1))                | a node "SMN" has no "load"
                    """)
    void robotsThatAreNotUnderstoodAreRefused(String node, String reason) {
        world.read(message(full(node.replace("BODY", "(nd TRF(SLT " + UNTURNED + "0 0 0 1))"))));

        assertThat(world.isCurrent()).isFalse();
        assertThat(problem()).isEqualTo("Message 1: " + reason + ".");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "(nd)(nd)", "(nd(nd))", "(nd TRF(SLT 1))", "(x)", "(nd(nd(nd)(nd)(nd)))", "((nd))"})
    void changesOfAnotherSceneEndItsCurrencyUntilTheNextFullMessage(String nodes) {
        world.read(message(full(PENDULUM)));

        assertThat(world.read(message(changes(nodes)))).isFalse();
        assertThat(problem()).startsWith("Message 2: ");
        assertThat(world.read(message(changes("(nd(nd(nd)(nd(nd(nd)))))")))).isFalse();
        assertThat(world.read(message(full(PENDULUM)))).isTrue();
        assertThat(world.problem()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"(nd TRF(SLT 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1)", "(nd DSC", "((", "(nd(nd"})
    void listsNestedHundredThousandDeepDoNoHarm(String list) {
        assertThat(world.read(message("((RSMP 1 0)((sg 1 0)full" + list.repeat(100_000))))
                .isFalse();
        assertThat(world.problem()).isPresent();
        assertThat(world.read(message("((RSMP 1 0)((gs 1 0)" + list.repeat(100_000))))
                .isFalse();
        assertThat(world.problem()).isPresent();
    }

    @Test
    void sizesAreLimited() {
        String leaf = "(nd TRF(SLT " + UNTURNED + "0 0 0 1))";

        world.read(message(full(leaf.repeat(20_000))));
        assertThat(problem()).isEqualTo("Message 1: the scene has more than 20000 nodes.");
        world.read(message("((RSMP 1 0)((ge 1 0)(play_modes" + " x".repeat(1000) + ")))"));
        assertThat(problem()).isEqualTo("Message 2: \"play_modes\" has more than 200 words, from \"x\" on.");
        world.read(message("((RSMP 1 0)((gs 1 0)(team_left " + "x".repeat(1000) + ")))"));
        assertThat(problem()).contains("a word has 1000 bytes; at most 200 are accepted");
    }

    @Test
    void damagedMessagesNeverStopTheReader() {
        List<String> recorded = RecordedMonitorMessages.load(RecordedMonitorMessages.T1_K1_ANT);
        Random random = new Random(7);

        for (int i = 0; i < 2000; i++) {
            MessageBuffer damaged = RecordedMonitorMessages.damaged(recorded.get(i % recorded.size()), random);
            assertThatCode(() -> {
                        world.read(damaged);
                        world.robots();
                        world.gameState();
                    })
                    .doesNotThrowAnyException();
        }
        assertThat(world.read(message(recorded.get(0)))).isTrue();
    }

    private String problem() {
        return world.problem().orElseThrow().toString();
    }

    private static String full(String nodes) {
        return "((RSMP 1 0)((gt 1 0)0.04)((sg 1 0)full" + tree(nodes) + ")" + GAME + ")";
    }

    private static String tree(String nodes) {
        return "(nd TRF(SLT " + UNTURNED + "0 0 0 1)" + nodes + ")";
    }

    private static String changes(String nodes) {
        return "((RSMP 1 0)((sg 1 0)diff(nd" + nodes + ")))";
    }
}
