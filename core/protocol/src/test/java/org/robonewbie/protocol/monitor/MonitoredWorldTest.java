package org.robonewbie.protocol.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.robonewbie.protocol.monitor.RecordedMonitorMessages.message;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.PlayerNumber;

class MonitoredWorldTest {

    private static final String SMALL = "((time 1)(play_modes A PlayOn)(play_mode 1))(RSG 0 1)"
            + "((nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1)(nd SMN (setVisible 1) (load StdUnitBox) (sMat a))))";

    private final MonitoredWorld world = new MonitoredWorld();

    @Test
    void nothingIsKnownBeforeTheFirstMessage() {
        assertThat(world.isCurrent()).isFalse();
        assertThat(world.robots()).isEmpty();
        assertThat(world.ball()).isEmpty();
        assertThat(world.gameState()).isEqualTo(MonitoredGame.UNKNOWN);
        assertThat(world.environment()).isEqualTo(Environment.UNKNOWN);
    }

    @Test
    void changesBeforeTheFirstFullMessageAreNotEnough() {
        boolean current = world.read(message("((time 2))(RDS 0 1)((nd))"));

        assertThat(current).isFalse();
        assertThat(world.gameState().timeSeconds()).isEqualTo(2);
    }

    @ParameterizedTest
    @ValueSource(strings = {"((nd))", "()", "((nd(nd SMN))(nd))", "((nd(nd SMN)(nd)))", "((nd(nd SMN(nd))))"})
    void changesOfAnotherSceneEndItsCurrencyUntilTheNextFullMessage(String graph) {
        world.read(message(SMALL));

        assertThat(world.read(message("((time 2))(RDS 0 1)" + graph))).isFalse();
        assertThat(world.read(message("((time 2))(RDS 0 1)((nd(nd SMN)))"))).isFalse();
        assertThat(world.read(message(SMALL))).isTrue();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "()",
                "((time 1))",
                "((time 1))(XYZ 0 1)()",
                "((time 1))(RSG 0 1)((nd TRF",
                "((time 1))(RSG 0 1)((nd))",
                "((time 1))(RSG 0 1)((nd TRF (SLT 1 2)))",
                "(RSMP 1 0)"
            })
    void brokenMessagesAreRefused(String text) {
        assertThat(world.read(message(text))).isFalse();
    }

    @Test
    void matrixThatIsNoNumberCountsAsZero() {
        world.read(message(SMALL.replace("1 2 3 1)", "-nan inf 3 1)")));

        TransformNode place = (TransformNode) world.scene().get(0);
        assertThat(place.position().x()).isZero();
        assertThat(place.position().y()).isZero();
        assertThat(place.position().z()).isEqualTo(3);
    }

    @Test
    void foulsOfOldAndNewServersAreUnderstood() {
        world.read(message("((time 1)(foul 7 6 2 4)(foul 1 1 10)(foul 8 99 1 1)(foul 9 0 5 1))(RSG 0 1)()"));

        assertThat(world.newFouls())
                .containsExactly(
                        new Foul(7, FoulType.CHARGING, new PlayerNumber(TeamSide.RIGHT, 4)),
                        new Foul(0, FoulType.TOUCHING, new PlayerNumber(TeamSide.LEFT, 10)));
    }

    @Test
    void playModesAreUnderstoodByName() {
        world.read(message(SMALL));

        assertThat(world.gameState().playMode()).contains(PlayMode.PLAY_ON);
        world.read(message("((time 2)(play_mode 0))(RDS 0 1)((nd(nd SMN)))"));
        assertThat(world.gameState().playMode()).isEmpty();
    }

    @Test
    void partsOfAForeignRobotAreFoundByTheirMeshes() {
        world.read(message("((time 1))(RSG 0 1)((nd TRF (nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 4 5 6 1)"
                + "(nd StaticMesh (load models/naobody2.obj)(resetMaterials matNum9 matRight matType2)))"
                + "(nd TRF (nd StaticMesh (load models/wheel.obj)))))"));

        MonitoredRobot robot = world.robot(new PlayerNumber(TeamSide.RIGHT, 9)).orElseThrow();
        assertThat(robot.type()).isEqualTo(RobotType.TYPE_2);
        assertThat(robot.link("body").orElseThrow().position().x()).isEqualTo(4);
        assertThat(robot.link("head")).isEmpty();
    }

    @Test
    void robotWithoutTeamIsNoPlayerYet() {
        world.read(message("((time 1))(RSG 0 1)((nd TRF (nd StaticMesh (load models/naobody0.obj)"
                + "(resetMaterials matNum matTeam matType0))))"));

        assertThat(world.isCurrent()).isTrue();
        assertThat(world.robots()).isEmpty();
    }

    @Test
    void nodesNestedHundredThousandDeepDoNoHarm() {
        String deep = "((time 1))(RSG 0 1)(" + "(nd TRF".repeat(100_000) + ")".repeat(100_001);

        assertThat(world.read(message(deep))).isFalse();
    }

    @Test
    void damagedMessagesNeverStopTheReader() {
        List<String> recorded = RecordedMonitorMessages.load(RecordedMonitorMessages.SIMSPARK);
        Random random = new Random(7);

        for (int i = 0; i < 3000; i++) {
            MessageBuffer damaged = RecordedMonitorMessages.damaged(recorded.get(i % recorded.size()), random);
            assertThatCode(() -> world.read(damaged)).doesNotThrowAnyException();
        }
        assertThat(world.read(message(recorded.get(0)))).isTrue();
    }
}
