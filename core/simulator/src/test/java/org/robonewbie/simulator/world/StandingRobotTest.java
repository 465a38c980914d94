package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;

class StandingRobotTest {

    private static final double WEIGHT_NEWTONS = 4.6071 * 9.81;

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private final Robot robot = world.addRobot(RobotType.TYPE_0);

    @BeforeEach
    void settle() {
        robot.moveUpright(new Vector3(-5, 0, 0.4), -90);
        for (int i = 0; i < 100; i++) {
            robot.setMotorSpeed(0, 1e-9);
            world.step();
        }
    }

    @Test
    void staysUprightWhereItWasPut() {
        assertThat(robot.torso().position().x()).isCloseTo(-5, within(1e-3));
        assertThat(robot.torso().position().z()).isCloseTo(0.3839, within(1e-4));
        assertThat(robot.torso().rotation().zz()).isGreaterThan(0.99999);
    }

    @Test
    void looksAlongXAfterYawOfMinusNinetyDegrees() {
        assertThat(robot.torso().rotation().axisY().x()).isCloseTo(1, within(1e-4));
    }

    @Test
    void feelsGravityAsUpwardAcceleration() {
        assertThat(robot.acceleration().distanceTo(new Vector3(0, 0, 9.81))).isLessThan(0.01);
    }

    @Test
    void feelsItsWeightUnderBothFeet() {
        double right = robot.footForces().right().orElseThrow().force().z();
        double left = robot.footForces().left().orElseThrow().force().z();

        assertThat(right + left).isCloseTo(WEIGHT_NEWTONS, within(0.05));
        assertThat(right).isCloseTo(left, within(0.05));
    }

    @Test
    void givesWayToThePushOfAHand() {
        robot.push(new Vector3(0, 20, 0));

        world.step();

        assertThat(robot.torsoVelocity().y()).isGreaterThan(0.01);
    }

    @Test
    void hasNoToeSensorsAsTypeZero() {
        assertThat(robot.footForces().rightToe()).isEmpty();
    }
}
