package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.RobotType;

class RobotBodyTest {

    /** Joints of the physics give way a little. */
    private static final double SLACK_METRES = 0.004;

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void limbsOfTheBodyAreWhereThePhysicsHasThem(RobotType type) {
        SoccerWorld world = new SoccerWorld(SoccerField.BEGINNER);
        Robot robot = world.addRobot(type);
        Random random = new Random(1);
        for (int i = 0; i < robot.nao().hinges().size(); i++) {
            robot.setMotorSpeed(i, random.nextDouble() - 0.5);
        }

        for (int i = 0; i < 100; i++) {
            world.step();
        }

        BodyState body = robot.body();
        List<Pose> links = body.limbs().links();
        for (int i = 0; i < links.size(); i++) {
            Pose physical = robot.linkPose(i).toBodyAxes();
            assertThat(links.get(i).position().distanceTo(physical.position())).isLessThan(SLACK_METRES);
            assertThat(links.get(i)
                            .rotation()
                            .times(physical.rotation().inverse())
                            .angleDegrees())
                    .isLessThan(1);
        }
        assertThat(body.headingDegrees()).isCloseTo(robot.headingDegrees(), within(1e-9));
        assertThat(body.tiltDegrees()).isCloseTo(robot.tiltDegrees(), within(1e-6));
        assertThat(body.isFallen()).isEqualTo(robot.isFallen());
    }
}
