package org.robonewbie.protocol.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.robonewbie.protocol.monitor.RecordedMonitorMessages.message;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.robot.BoosterK1;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotState;

class RsmpTraceTest {

    private final RsmpWorld world = new RsmpWorld();

    @Test
    void everyMessageIsUnderstood() {
        for (String resource : List.of(RecordedMonitorMessages.T1, RecordedMonitorMessages.T1_K1_ANT)) {
            for (String line : RecordedMonitorMessages.load(resource)) {
                assertThat(world.read(message(line))).as("%s", world.problem()).isTrue();
            }
        }
    }

    @Test
    void firstMessageTellsPitchAndRobot() {
        world.read(
                message(RecordedMonitorMessages.load(RecordedMonitorMessages.T1).get(0)));

        assertThat(world.environment().measure("FieldWidth")).hasValue(36);
        assertThat(world.environment().playModes()).hasSize(23);
        assertThat(world.gameState())
                .isEqualTo(new MonitoredGame(
                        0,
                        Optional.of("Blue"),
                        Optional.empty(),
                        1,
                        0,
                        0,
                        Optional.of(PlayMode.BEFORE_KICK_OFF),
                        0,
                        0));
        assertThat(world.seconds()).isEqualTo(2.44);
        assertThat(world.ball().orElseThrow().position().z()).isEqualTo(0.11);
        RsmpRobot robot = world.robots().get(0);
        assertThat(robot.player()).isEqualTo(new PlayerNumber(TeamSide.LEFT, 2));
        assertThat(robot.state().model()).isSameAs(BoosterT1.MODEL);
        assertThat(robot.state().torso().position().x()).isEqualTo(-1.9998);
        assertThat(robot.state().isFallen()).isFalse();
    }

    @Test
    void changesMoveJointsAndGame() {
        RecordedMonitorMessages.load(RecordedMonitorMessages.T1).forEach(line -> world.read(message(line)));

        assertThat(world.gameState().playMode()).contains(PlayMode.KICK_OFF_LEFT);
        assertThat(world.gameState().timeSeconds()).isEqualTo(5.04);
        assertThat(world.ball().orElseThrow().position().x()).isEqualTo(5.6154);
        RobotState robot = world.robots().get(0).state();
        assertThat(robot.isFallen()).isTrue();
        int knee = BoosterT1.MODEL.joint("lle4").orElseThrow().index();
        assertThat(robot.degrees(knee)).isCloseTo(4.6, within(0.1));
    }

    @Test
    void modelsAreRecognised() {
        RecordedMonitorMessages.load(RecordedMonitorMessages.T1_K1_ANT).forEach(line -> world.read(message(line)));

        List<RsmpRobot> robots = world.robots();
        assertThat(robots)
                .extracting(RsmpRobot::player)
                .containsExactly(
                        new PlayerNumber(TeamSide.LEFT, 2),
                        new PlayerNumber(TeamSide.RIGHT, 3),
                        new PlayerNumber(TeamSide.LEFT, 4));
        assertThat(robots.get(0).state().model()).isSameAs(BoosterT1.MODEL);
        assertThat(robots.get(1).state().model()).isSameAs(BoosterK1.MODEL);
        assertThat(robots.get(2).state().model().name()).isEqualTo("robot");
        assertThat(robots.get(2).state().model().bodies().get(0).shapes()).hasSize(1);
    }

    /** The places were computed with NumPy from the transforms of the message. */
    @Test
    void jointAnglesPutTheBodiesWhereTheServerHasThem() {
        world.read(message(
                RecordedMonitorMessages.load(RecordedMonitorMessages.T1_K1_ANT).get(0)));

        Vector3 t1 = bodyPosition(world.robots().get(0).state(), "left_foot_link");
        Vector3 k1 = bodyPosition(world.robots().get(1).state(), "right_foot_link");
        assertThat(t1.minus(new Vector3(-1.97033, -1.42668, 0.15892)).length()).isLessThan(0.001);
        assertThat(k1.minus(new Vector3(1.86015, 0.10352, 0.13320)).length()).isLessThan(0.001);
    }

    private static Vector3 bodyPosition(RobotState robot, String body) {
        double[] degrees =
                IntStream.range(0, robot.joints()).mapToDouble(robot::degrees).toArray();
        int index = robot.model().bodyIndex(body);
        return robot.torso().times(robot.model().bodyPoses(degrees).get(index)).position();
    }
}
