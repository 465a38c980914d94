package org.robonewbie.protocol.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.robonewbie.protocol.monitor.RecordedMonitorMessages.message;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.PlayerNumber;

class MonitorTraceTest {

    private static final int SECOND_FULL_MESSAGE = 41;

    private final List<String> recorded = RecordedMonitorMessages.load(RecordedMonitorMessages.SIMSPARK);
    private final MonitoredWorld world = new MonitoredWorld();

    @Test
    void firstMessageTellsTheWholeSoccerScene() {
        boolean understood = world.read(message(recorded.get(0)));

        assertThat(understood).isTrue();
        assertThat(world.scene()).hasSize(37);
        assertThat(world.environment().measure("FieldLength")).hasValue(30);
        assertThat(world.environment().measure("PassModeDuration")).hasValue(4);
        assertThat(world.environment().measure("Unheard")).isEmpty();
        assertThat(world.environment().playModes())
                .hasSize(PlayMode.simSparkModes().size());
        assertThat(world.gameState())
                .isEqualTo(new MonitoredGame(
                        0, Optional.of("X"), Optional.empty(), 1, 0, 0, Optional.of(PlayMode.BEFORE_KICK_OFF), 0, 0));
    }

    @Test
    void robotAndBallAreFoundInTheFirstMessage() {
        world.read(message(recorded.get(0)));

        MonitoredRobot robot = world.robot(new PlayerNumber(TeamSide.LEFT, 1)).orElseThrow();
        assertThat(world.robots()).containsExactly(robot);
        assertThat(robot.type()).isEqualTo(RobotType.TYPE_0);
        TransformNode torso = robot.link(NaoModel.TORSO).orElseThrow();
        assertThat(torso.position().x()).isCloseTo(-1.03317, within(1e-6));
        assertThat(torso.axisZ().z()).isEqualTo(1);
        assertThat(torso.axisY().x()).isCloseTo(0.997791, within(1e-6));
        assertThat(robot.link("lfoot").orElseThrow().position().z()).isCloseTo(0.00897175, within(1e-8));
        assertThat(robot.link("tail")).isEmpty();
        assertThat(world.ball().orElseThrow().position().z()).isCloseTo(0.0417605, within(1e-7));
    }

    @Test
    void updatesMoveBallAndChangePlayMode() {
        recorded.subList(0, 22).forEach(line -> world.read(message(line)));
        double ballX = world.ball().orElseThrow().position().x();

        recorded.subList(22, recorded.size()).forEach(line -> world.read(message(line)));

        assertThat(ballX).isCloseTo(1.01985, within(1e-6));
        assertThat(world.isCurrent()).isTrue();
        assertThat(world.gameState().playMode()).contains(PlayMode.PLAY_ON);
        assertThat(world.gameState().timeSeconds()).isEqualTo(0.78);
        assertThat(world.robots().get(0).link("head").orElseThrow().axisX().x()).isCloseTo(0.0164933, within(1e-7));
    }

    @Test
    void whatWasReadIsWrittenAgainByteForByte() {
        world.read(message(recorded.get(0)));
        MonitorMessageWriter writer = new MonitorMessageWriter(world.environment());

        assertThat(writeFull(writer)).isEqualTo(recorded.get(0));
        for (String line : recorded.subList(1, SECOND_FULL_MESSAGE)) {
            world.read(message(line));
            assertThat(writePartial(writer)).isEqualTo(line);
        }
        world.read(message(recorded.get(SECOND_FULL_MESSAGE)));
        assertThat(writeFull(writer)).isEqualTo(recorded.get(SECOND_FULL_MESSAGE));
    }

    private String writeFull(MonitorMessageWriter writer) {
        return writer.writeFull(world.gameState(), world.newFouls(), world.scene())
                .toString();
    }

    private String writePartial(MonitorMessageWriter writer) {
        return writer.writePartial(world.gameState(), world.newFouls(), world.scene())
                .toString();
    }
}
