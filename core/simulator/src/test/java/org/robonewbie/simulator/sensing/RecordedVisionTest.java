package org.robonewbie.simulator.sensing;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** Replays what the recorded agents did and compares every picture with what the original sent, without noise. */
class RecordedVisionTest {

    private static final Vector3 CENTRE_SPOT = new Vector3(0, 0, 0.042);

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private final List<Supplier<VisiblePlayer>> players = new ArrayList<>();
    private int numbers;
    private int equalNumbers;

    @Test
    void aRobotThatJoinsFallsAndIsBeamedSeesTheSame() throws IOException {
        List<PerceptorMessage> messages = RecordedMessages.read("a_agent_100msgs_sync_fast_nonoise");
        Robot robot = world.addRobot(RobotType.TYPE_0);
        Camera camera = camera();
        stepBeforeKickOff();

        for (int i = 0; i < messages.size(); i++) {
            if (i == 2) {
                robot.moveUpright(new Vector3(-14.2, 9.2, 0.4), -90);
                players.add(() -> new VisiblePlayer(robot, "X", 1));
            } else if (i == 3) {
                robot.beam(new Vector3(-3, 0.5, 0.4), -90);
            }
            stepBeforeKickOff();
            compareSensors(messages.get(i), robot);
            compareVision(messages.get(i), robot, camera);
        }

        assertThat(messages).hasSize(100);
        assertThat(equalNumbers).isGreaterThan((int) (0.99 * numbers));
        assertThat(numbers).isGreaterThan(4000);
    }

    @Test
    void aRobotAmongOthersSeesTheirParts() throws IOException {
        List<PerceptorMessage> messages = RecordedMessages.read("a_agent_two_teams_hear_playon_nonoise");
        Robot observer = hang("Alpha", 1, -3, 0, -90);
        hang("Alpha", 2, -1.5, 1, 90);
        stand("Beta", 1, 2, 0, 90);
        stand("Beta", 2, 4, 1, 90);
        Camera camera = camera();

        for (PerceptorMessage message : messages) {
            if (message.gameState().orElseThrow().playModeName().equals("BeforeKickOff")) {
                stepBeforeKickOff();
            } else {
                world.step();
            }
            compareVision(message, observer, camera);
        }

        assertThat(messages).hasSize(120);
        assertThat(equalNumbers).isGreaterThan((int) (0.99 * numbers));
        assertThat(numbers).isGreaterThan(4000);
    }

    /** Lets a robot fall asleep somewhere and then beams it, so that it hangs in the air as the recorded ones did. */
    private Robot hang(String team, int number, double x, double y, double yawDegrees) {
        Robot robot = world.addRobot(RobotType.TYPE_0);
        robot.moveUpright(new Vector3(-14.2, 9.2 - 2 * players.size(), 0.4), yawDegrees);
        for (int i = 0; i < 60; i++) {
            stepBeforeKickOff();
        }
        robot.beam(new Vector3(x, y, 0.4), yawDegrees);
        players.add(() -> new VisiblePlayer(robot, team, number));
        return robot;
    }

    private void stand(String team, int number, double x, double y, double yawDegrees) {
        Robot robot = hang(team, number, x, y, yawDegrees);
        robot.wake();
        for (int i = 0; i < 60; i++) {
            stepBeforeKickOff();
        }
    }

    private static Camera camera() {
        CameraSettings withoutNoise = CameraSettings.STANDARD.withNoise(false);
        return new Camera(SoccerField.LEAGUE, withoutNoise, new SplittableRandom(1));
    }

    /** Before the kick-off the referee puts the ball back after every step. */
    private void stepBeforeKickOff() {
        world.step();
        world.ball().place(CENTRE_SPOT);
    }

    private void compareSensors(PerceptorMessage message, Robot robot) {
        assertEqual(message.accelerometer().orElseThrow(), robot.acceleration());
        assertEqual(message.gyro().orElseThrow(), robot.gyroDegreesPerSecond());
        message.footForces()
                .right()
                .ifPresentOrElse(
                        printed -> {
                            assertEqual(
                                    printed.point(),
                                    robot.footForces().right().orElseThrow().point());
                            assertEqual(
                                    printed.force(),
                                    robot.footForces().right().orElseThrow().force());
                        },
                        () -> assertThat(robot.footForces().right()).isEmpty());
    }

    private void compareVision(PerceptorMessage message, Robot observer, Camera camera) {
        if (message.vision().isEmpty()) {
            return;
        }
        Vision printed = message.vision().get();
        List<VisiblePlayer> now = players.stream().map(Supplier::get).toList();
        Vision seen = camera.look(observer, world, now, Optional.empty());
        assertThat(seen.landmarks())
                .extracting(Vision.SeenLandmark::landmark)
                .containsExactlyInAnyOrderElementsOf(printed.landmarks().stream()
                        .map(Vision.SeenLandmark::landmark)
                        .toList());
        for (Vision.SeenLandmark landmark : printed.landmarks()) {
            assertEqual(
                    landmark.position(),
                    seen.landmarks().stream()
                            .filter(other -> other.landmark() == landmark.landmark())
                            .findFirst()
                            .orElseThrow()
                            .position());
        }
        assertThat(seen.ball().isPresent()).isEqualTo(printed.ball().isPresent());
        printed.ball().ifPresent(ball -> assertEqual(ball, seen.ball().orElseThrow()));
        comparePlayers(printed, seen);
        assertThat(seen.lines()).hasSameSizeAs(printed.lines());
        for (int i = 0; i < seen.lines().size(); i++) {
            assertEqual(printed.lines().get(i).start(), seen.lines().get(i).start());
            assertEqual(printed.lines().get(i).end(), seen.lines().get(i).end());
        }
    }

    private void comparePlayers(Vision printed, Vision seen) {
        assertThat(seen.players()).hasSameSizeAs(printed.players());
        for (Vision.SeenPlayer player : printed.players()) {
            Vision.SeenPlayer same = seen.players().stream()
                    .filter(other -> other.team().equals(player.team()) && other.number() == player.number())
                    .findFirst()
                    .orElseThrow();
            assertThat(same.parts()).hasSameSizeAs(player.parts());
            for (int i = 0; i < same.parts().size(); i++) {
                assertThat(same.parts().get(i).part())
                        .isEqualTo(player.parts().get(i).part());
                assertEqual(
                        player.parts().get(i).position(), same.parts().get(i).position());
            }
        }
    }

    private void assertEqual(PolarPosition printed, PolarPosition exact) {
        assertEqual(printed.distanceMetres(), exact.distanceMetres());
        assertEqual(printed.horizontalDegrees(), exact.horizontalDegrees());
        assertEqual(printed.verticalDegrees(), exact.verticalDegrees());
    }

    private void assertEqual(Vector3 printed, Vector3 exact) {
        assertEqual(printed.x(), exact.x());
        assertEqual(printed.y(), exact.y());
        assertEqual(printed.z(), exact.z());
    }

    /** At most one unit of the last printed digit apart; counts those that are not apart at all. */
    private void assertEqual(double printed, double exact) {
        double rounded = Math.rint(exact * 100) / 100;
        assertThat(Math.abs(rounded - printed))
                .describedAs("%s was printed, %s was simulated", printed, exact)
                .isLessThan(0.0101);
        numbers++;
        if (Math.abs(rounded - printed) < 0.001) {
            equalNumbers++;
        }
    }
}
