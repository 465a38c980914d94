package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.robot.BoosterK1;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.NaoRobot;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.state.WorldState;

class RobotOfAnyModelTest {

    private static final int CYCLES_TO_LAND = 60;
    private static final double SLACK_METRES = 0.002;

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);

    static Stream<RobotModel> leagueRobots() {
        return Stream.of(BoosterT1.MODEL, BoosterK1.MODEL);
    }

    @ParameterizedTest
    @MethodSource("leagueRobots")
    void robotOfTheLeagueStandsWithItsJointsHeld(RobotModel model) {
        Robot robot = standing(model);

        assertThat(robot.isStanding()).isTrue();
        assertThat(robot.tiltDegrees()).isLessThan(1);
        assertThat(robot.boundingBox().min().z()).isCloseTo(0, within(SLACK_METRES));
        assertThat(model.joints())
                .allSatisfy(joint -> assertThat(robot.jointDegrees(joint)).isCloseTo(0, within(1.0)));
    }

    @ParameterizedTest
    @MethodSource("leagueRobots")
    void linksAreWhereForwardKinematicsPutsThem(RobotModel model) {
        Robot robot = standing(model);

        for (int i = 0; i < 20; i++) {
            model.joints().forEach(joint -> robot.setMotorSpeed(joint, 1 - joint.index() % 3));
            world.step();
        }

        RobotState state = robot.state();
        double[] degrees = model.joints().stream()
                .mapToDouble(joint -> state.degrees(joint.index()))
                .toArray();
        List<Pose> poses = model.bodyPoses(degrees);
        assertThat(Arrays.stream(degrees).max().orElseThrow()).isGreaterThan(20);
        for (int i = 0; i < poses.size(); i++) {
            Vector3 expected = state.torso().times(poses.get(i)).position();
            assertThat(robot.linkPosition(i).distanceTo(expected)).isLessThan(SLACK_METRES);
        }
    }

    @Test
    void modelOfANaoMakesANao() {
        Robot robot = world.addRobot(NaoRobot.of(RobotType.TYPE_4));

        assertThat(robot.isNao()).isTrue();
        assertThat(robot.type()).isEqualTo(RobotType.TYPE_4);
        assertThat(robot.body().type()).isEqualTo(RobotType.TYPE_4);
    }

    @Test
    void onlyANaoHasAType() {
        Robot robot = world.addRobot(BoosterT1.MODEL);

        assertThat(robot.isNao()).isFalse();
        assertThatIllegalStateException()
                .isThrownBy(robot::type)
                .withMessage("The robot is a T1. Only a NAO can be used here.");
    }

    @Test
    void bodyWithoutMassIsRefused() {
        List<RobotBody> bodies = new ArrayList<>(BoosterT1.MODEL.bodies());
        RobotBody head = bodies.get(1);
        bodies.set(
                1, new RobotBody(head.name(), 0, head.pose(), 0, head.inertialPose(), head.inertia(), head.shapes()));
        RobotModel model = new RobotModel("Ghost", bodies, BoosterT1.MODEL.joints(), 0.6);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.addRobot(model))
                .withMessage(
                        "Body \"H1\" of robot Ghost has no mass or no inertia. Give each body both, so that it can be"
                                + " simulated.");
        assertThat(world.robots()).isEmpty();
    }

    @Test
    void bodyWithoutJointIsRefused() {
        List<RobotJoint> joints = BoosterT1.MODEL.joints().subList(0, 22);
        RobotModel model = new RobotModel("Loose", BoosterT1.MODEL.bodies(), joints, 0.6);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.addRobot(model))
                .withMessageContaining("has 0 joints. Give each body but the torso exactly one.");
    }

    @Test
    void stateWithAnUnknownModelIsRefused() {
        world.addRobot(BoosterT1.MODEL);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SoccerWorld(SoccerField.LEAGUE).restore(world.save()))
                .withMessageContaining("a robot of the model T1, which this world has never had");
    }

    @Test
    void removedRobotOfAnotherModelComesBackWithTheState() {
        Robot robot = standing(BoosterT1.MODEL);
        Vector3 place = robot.torso().position();
        WorldState state = world.save();
        world.removeRobot(robot);

        world.restore(state);

        assertThat(world.robots()).hasSize(1);
        assertThat(world.robots().get(0).torso().position()).isEqualTo(place);
    }

    private Robot standing(RobotModel model) {
        Robot robot = world.addRobot(model);
        robot.moveUpright(new Vector3(1, 2, model.stanceHeight() + 0.05), -90);
        for (int i = 0; i < CYCLES_TO_LAND; i++) {
            world.step();
        }
        return robot;
    }
}
