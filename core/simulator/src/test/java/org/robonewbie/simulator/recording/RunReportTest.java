package org.robonewbie.simulator.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.SoccerWorld;

class RunReportTest {

    @TempDir
    private Path folder;

    private final SoccerWorld world =
            new SoccerWorld(SoccerParameters.beginner().field());
    private final Match match = new Match(world, SoccerParameters.beginner(), 1);
    private RunRecorder recorder;
    private Player player;
    private long cycle;

    @BeforeEach
    void begin() throws Exception {
        recorder = RunRecorder.begin(world, RecordingTarget.NONE, List.of());
        player = match.teams().join("Stars", 3, world.addRobot(RobotType.TYPE_0));
        player.robot().moveUpright(new Vector3(-2, 1, 0.386), -90);
        cycles(50);
    }

    @Test
    void tellsPlaceAndHeadingInTheWorldFrame() throws Exception {
        RunReport.RobotResult robot = result();

        assertThat(robot.position().x()).isCloseTo(-2, within(0.01));
        assertThat(robot.position().y()).isCloseTo(1, within(0.01));
        assertThat(robot.headingDegrees()).isCloseTo(0, within(0.5));
        assertThat(robot.upright()).isTrue();
        assertThat(robot.falls()).isZero();
    }

    @Test
    void countsAFallOnceUntilTheRobotStandsAgain() throws Exception {
        for (int i = 0; i < 100; i++) {
            player.robot().setMotorSpeed(Joint.LEFT_FOOT_PITCH, -3);
            player.robot().setMotorSpeed(Joint.RIGHT_FOOT_PITCH, -3);
            cycles(1);
        }
        RunReport.RobotResult lying = result();
        player.robot().moveUpright(new Vector3(0, 2, 0.5), -90);
        cycles(1);

        assertThat(lying.falls()).isEqualTo(1);
        assertThat(lying.upright()).isFalse();
        assertThat(result().falls()).isEqualTo(1);
    }

    @Test
    void swayingOnTheSpotIsNoWalking() throws Exception {
        for (int i = 0; i < 500; i++) {
            double speed = 0.6 * Math.cos(i * 0.2);
            player.robot().setMotorSpeed(Joint.LEFT_FOOT_ROLL, speed);
            player.robot().setMotorSpeed(Joint.RIGHT_FOOT_ROLL, speed);
            cycles(1);
        }

        assertThat(result().metresWalked()).isLessThan(0.15);
    }

    @Test
    void beingBeamedIsNoWalking() throws Exception {
        player.robot().beam(new Vector3(4, -2, 0.386), -90);
        cycles(50);

        assertThat(result().metresWalked()).isLessThan(0.05);
        assertThat(result().position().x()).isCloseTo(4, within(0.02));
    }

    @Test
    void measuresTheBallWithoutTheRefereesHand() throws Exception {
        match.setPlayMode(PlayMode.PLAY_ON);
        world.ball().moveTo(new Vector3(3, 0, 0.042));
        world.ball().setVelocity(new Vector3(1, 0, 0));

        cycles(400);
        Vector3 end = world.ball().position();
        world.ball().place(new Vector3(-4, 0, 0.042));
        cycles(1);

        RunReport.Ball ball = report().ball();
        assertThat(ball.metresMoved()).isCloseTo(end.x() - 3, within(0.02));
        assertThat(ball.leastDistanceToGoal()).isCloseTo(6 - end.x(), within(0.02));
        assertThat(ball.position().x()).isCloseTo(-4, within(0.01));
    }

    @Test
    void writesAllThatIsPromisedAsJson() throws Exception {
        Path file = folder.resolve("report.json");

        AtomicFile.write(file, report().toJson());

        JsonObject json = JsonParser.parseString(Files.readString(file)).getAsJsonObject();
        assertThat(json.keySet())
                .containsExactly(
                        "seed",
                        "simulatedSeconds",
                        "wallSeconds",
                        "realTimeFactor",
                        "missedCycles",
                        "robots",
                        "ball",
                        "goals",
                        "recordingSha256");
        JsonObject robot = json.getAsJsonArray("robots").get(0).getAsJsonObject();
        assertThat(robot.keySet())
                .contains("team", "number", "falls", "metresWalked", "x", "y", "headingDegrees", "upright", "joints");
        assertThat(robot.getAsJsonObject("joints").keySet()).hasSize(22).contains("LEFT_SHOULDER_PITCH");
        assertThat(json.getAsJsonObject("ball").keySet()).contains("x", "y", "z", "metresMoved", "leastDistanceToGoal");
        assertThat(json.get("recordingSha256").getAsString()).hasSize(64);
    }

    @Test
    void keepsTheLastThousandRobotsThatHaveLeft() {
        for (int id = 2; id <= 1100; id++) {
            cycle(List.of(participant(id)));
        }

        List<RunReport.RobotResult> robots = report().robots();

        assertThat(robots).hasSize(1001);
        cycle(List.of(participant(2), participant(1100)));
        assertThat(report().robots()).hasSize(1002);
    }

    private void cycles(int count) {
        for (int i = 0; i < count; i++) {
            cycle(List.of(participant(1)));
        }
    }

    private Participant participant(int id) {
        return new Participant(id, Optional.of(player), player.robot(), List.of(), 0);
    }

    private void cycle(List<Participant> participants) {
        recorder.beforeStep(participants);
        world.step();
        recorder.afterStep();
        cycle++;
        recorder.cycleEnded(cycle, match, participants);
    }

    private RunReport report() {
        return recorder.report(5, 2, 0);
    }

    private RunReport.RobotResult result() {
        return report().robots().get(0);
    }
}
