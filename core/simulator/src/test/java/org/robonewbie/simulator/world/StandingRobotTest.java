package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Link;
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
    void shoulderHoldsTheWeightOfTheArm() {
        assertThat(Math.abs(robot.jointTorque(Joint.LEFT_SHOULDER_PITCH))).isCloseTo(armTorque(), within(0.003));
        assertThat(robot.jointTorque(Joint.RIGHT_SHOULDER_PITCH))
                .isCloseTo(robot.jointTorque(Joint.LEFT_SHOULDER_PITCH), within(0.003));
    }

    @Test
    void shoulderGivesWayIfItIsTooWeak() {
        robot.setStrength(Joint.LEFT_SHOULDER_PITCH, 0.5 * armTorque() / Robot.MAX_TORQUE);
        robot.setStrength(Joint.RIGHT_SHOULDER_PITCH, 2 * armTorque() / Robot.MAX_TORQUE);

        step(20);

        assertThat(robot.jointDegrees(Joint.LEFT_SHOULDER_PITCH)).isLessThan(-5);
        assertThat(robot.jointDegrees(Joint.RIGHT_SHOULDER_PITCH)).isCloseTo(0, within(0.5));
    }

    /** Torque of gravity about the shoulder, from the masses and positions of the links of the left arm, which points forward. */
    private double armTorque() {
        List<Link> links = robot.nao().links();
        double shoulder = robot.torso().position().x()
                + robot.nao()
                        .hinges()
                        .get(robot.nao().hingeIndex(Joint.LEFT_SHOULDER_PITCH))
                        .anchor()
                        .y();
        return IntStream.range(0, links.size())
                .filter(i -> links.get(i).name().matches("l(shoulder|upperarm|elbow|lowerarm)"))
                .mapToDouble(i ->
                        links.get(i).massKg() * 9.81 * (robot.linkPosition(i).x() - shoulder))
                .sum();
    }

    @Test
    void slipsTwiceAsFastOnSolesOfHalfTheGrip() {
        double normal = slide();
        settle();
        robot.setSoleGrip(0.5);
        double slippery = slide();
        robot.restoreProperties();
        settle();

        assertThat(slippery).isCloseTo(2 * normal, withinPercentage(10));
        assertThat(slide()).isCloseTo(normal, withinPercentage(1));
    }

    private double slide() {
        double before = foot();
        for (int i = 0; i < 5; i++) {
            robot.push(new Vector3(0, 5, 0));
            world.step();
        }
        return foot() - before;
    }

    private double foot() {
        return robot.linkPosition(robot.nao().linkIndex("lfoot")).y();
    }

    @Test
    void tiltsToTheSideOfATwist() {
        for (int i = 0; i < 10; i++) {
            robot.twist(new Vector3(0, 5, 0));
            world.step();
        }

        assertThat(robot.torso().rotation().zz()).isLessThan(0.9999);
        assertThat(robot.torso().position().x()).isGreaterThan(-5);
    }

    private void step(int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
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
