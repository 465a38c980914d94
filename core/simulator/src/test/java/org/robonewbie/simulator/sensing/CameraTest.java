package org.robonewbie.simulator.sensing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

class CameraTest {

    private static final CameraSettings EXACT = CameraSettings.STANDARD.withNoise(false);

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private final Robot robot = world.addRobot(RobotType.TYPE_0);

    @BeforeEach
    void lookAlongTheFieldFromTheCentreSpot() {
        robot.moveUpright(new Vector3(0, 0, 0.385), -90);
    }

    @Test
    void anglesArePositiveToTheLeftAndUp() {
        world.ball().place(new Vector3(1, 1, 0.54 + Math.sqrt(2)));

        Vision vision = look(EXACT);

        assertThat(vision.ball().orElseThrow().distanceMetres()).isCloseTo(2, within(1e-6));
        assertThat(vision.ball().orElseThrow().horizontalDegrees()).isCloseTo(45, within(1e-6));
        assertThat(vision.ball().orElseThrow().verticalDegrees()).isCloseTo(45, within(1e-6));
    }

    @Test
    void sixtyDegreesToEachSideAreVisible() {
        world.ball().place(at(59.9));
        assertThat(look(EXACT).ball()).isPresent();

        world.ball().place(at(60.1));
        assertThat(look(EXACT).ball()).isEmpty();

        world.ball().place(at(-59.9));
        assertThat(look(EXACT).ball()).isPresent();
    }

    @Test
    void whatIsNearerThanTenCentimetresIsNotSeen() {
        world.ball().place(new Vector3(0.11, 0, 0.54));
        assertThat(look(EXACT).ball()).isPresent();

        world.ball().place(new Vector3(0.09, 0, 0.54));
        assertThat(look(EXACT).ball()).isEmpty();
    }

    @Test
    void seesTheLandmarksOfTheSideToWhichItLooks() {
        assertThat(look(EXACT).landmarks())
                .extracting(Vision.SeenLandmark::landmark)
                .containsExactly(
                        Landmark.GOAL_POST_2_RIGHT,
                        Landmark.GOAL_POST_1_RIGHT,
                        Landmark.FLAG_1_RIGHT,
                        Landmark.FLAG_2_RIGHT);
    }

    @Test
    void seesItsOwnForearmsUnderItsOwnNumber() {
        Vision.SeenPlayer own = look(EXACT).players().get(0);

        assertThat(own.team()).isEqualTo("Stars");
        assertThat(own.number()).isEqualTo(7);
        assertThat(own.parts())
                .extracting(Vision.SeenBodyPart::part)
                .containsExactly(BodyPart.RIGHT_LOWER_ARM, BodyPart.LEFT_LOWER_ARM);
    }

    @Test
    void doesNotSeeRobotsWithoutATeam() {
        Robot other = world.addRobot(RobotType.TYPE_0);
        other.moveUpright(new Vector3(2, 0, 0.385), 90);

        assertThat(look(EXACT).players()).hasSize(1);
    }

    @Test
    void linesCanBeSwitchedOff() {
        assertThat(look(EXACT).lines()).isNotEmpty();
        assertThat(look(EXACT.withLines(false)).lines()).isEmpty();
    }

    @Test
    void truthIsOffByDefault() {
        Vision vision = look(CameraSettings.STANDARD);

        assertThat(vision.ownPosition()).isEmpty();
        assertThat(vision.ownOrientationDegrees()).isEmpty();
        assertThat(vision.ballPosition()).isEmpty();
    }

    @Test
    void truthIsInTheViewOfTheOwnTeam() {
        robot.moveUpright(new Vector3(3, 2, 0.385), 90);
        world.ball().place(new Vector3(4, 1, 0.042));
        Camera camera = camera(EXACT.withTruth(true, true, true), 1);

        Vision right = camera.look(robot, world, players(), Optional.of(TeamSide.RIGHT));
        Vision left = camera.look(robot, world, players(), Optional.of(TeamSide.LEFT));

        assertThat(right.ownPosition().orElseThrow().distanceTo(new Vector3(-3, -2, 0.54)))
                .isLessThan(1e-9);
        assertThat(right.ownOrientationDegrees().orElseThrow()).isCloseTo(0, within(1e-9));
        assertThat(right.ballPosition()).contains(new Vector3(-4, -1, 0.042));
        assertThat(left.ownPosition().orElseThrow().distanceTo(new Vector3(3, 2, 0.54)))
                .isLessThan(1e-9);
        assertThat(Math.abs(left.ownOrientationDegrees().orElseThrow())).isCloseTo(180, within(1e-9));
        assertThat(left.ballPosition()).contains(new Vector3(4, 1, 0.042));
    }

    @Test
    void sameSeedGivesTheSamePicturesAndAnotherSeedOthers() {
        Vision first = camera(CameraSettings.STANDARD, 5).look(robot, world, players(), Optional.empty());
        Vision same = camera(CameraSettings.STANDARD, 5).look(robot, world, players(), Optional.empty());
        Vision other = camera(CameraSettings.STANDARD, 6).look(robot, world, players(), Optional.empty());

        assertThat(same).isEqualTo(first);
        assertThat(other).isNotEqualTo(first);
    }

    private List<VisiblePlayer> players() {
        return List.of(new VisiblePlayer(robot, "Stars", 7));
    }

    private Vision look(CameraSettings settings) {
        return camera(settings, 1).look(robot, world, players(), Optional.empty());
    }

    private static Camera camera(CameraSettings settings, long seed) {
        return new Camera(SoccerField.LEAGUE, settings, new SplittableRandom(seed));
    }

    private static Vector3 at(double degrees) {
        double angle = Math.toRadians(degrees);
        return new Vector3(3 * Math.cos(angle), 3 * Math.sin(angle), 0.54);
    }
}
