package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;

/** Motors of a robot that falls freely, so that nothing but the joints themselves is in the way. */
class MotorTest {

    private static final double SLOW = 0.5;
    private static final double FAST = 3;

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private final Robot robot = world.addRobot(RobotType.TYPE_0);

    @BeforeEach
    void lift() {
        robot.moveTo(new Vector3(0, 0, 500));
    }

    @ParameterizedTest
    @EnumSource
    void reachesBothEndsOfItsRangeAndStopsThere(Joint joint) {
        drive(joint, 1);
        double highest = robot.jointDegrees(joint);
        drive(joint, -1);
        double lowest = robot.jointDegrees(joint);

        assertThat(highest).isCloseTo(joint.maxDegrees(), within(1.0));
        assertThat(lowest).isCloseTo(joint.minDegrees(), within(1.0));
    }

    @Test
    void turnsByTheCommandedSpeedPerSecond() {
        robot.setMotorSpeed(Joint.LEFT_KNEE_PITCH, -1);
        step(50);

        assertThat(robot.jointDegrees(Joint.LEFT_KNEE_PITCH)).isCloseTo(-Math.toDegrees(1), within(0.05));
    }

    @Test
    void measuresItsSpeed() {
        robot.setMotorSpeed(Joint.LEFT_KNEE_PITCH, -1);
        step(5);

        assertThat(robot.jointDegreesPerSecond(Joint.LEFT_KNEE_PITCH)).isCloseTo(-Math.toDegrees(1), within(0.1));
    }

    @Test
    void isCutToItsGreatestSpeed() {
        robot.setMotorSpeed(Joint.RIGHT_SHOULDER_PITCH, 100);
        step(10);

        assertThat(robot.jointDegrees(Joint.RIGHT_SHOULDER_PITCH)).isCloseTo(351.77 / 5, within(0.1));
    }

    @Test
    void keepsItsSpeedUntilTheNextCommand() {
        robot.setMotorSpeed(Joint.NECK_YAW, 1);
        step(10);
        robot.setMotorSpeed(Joint.NECK_YAW, 0);
        double angle = robot.jointDegrees(Joint.NECK_YAW);
        step(10);

        assertThat(angle).isCloseTo(Math.toDegrees(0.2), within(0.05));
        assertThat(robot.jointDegrees(Joint.NECK_YAW)).isCloseTo(angle, within(0.05));
    }

    @Test
    void ignoresCommandsBeyondAStop() {
        robot.setMotorSpeed(Joint.LEFT_ARM_YAW, 1);
        step(1);
        assertThat(robot.jointDegrees(Joint.LEFT_ARM_YAW)).isGreaterThan(Joint.LEFT_ARM_YAW.maxDegrees());

        robot.setMotorSpeed(Joint.LEFT_ARM_YAW, -SLOW);
        step(1);
        double afterIgnoredCommand = robot.jointDegrees(Joint.LEFT_ARM_YAW);
        step(1);

        assertThat(afterIgnoredCommand).isGreaterThan(-0.5);
        assertThat(robot.jointDegrees(Joint.LEFT_ARM_YAW)).isGreaterThan(-0.5);
    }

    @Test
    void ignoresSpeedsThatAreNoNumbers() {
        robot.setMotorSpeed(Joint.NECK_YAW, Double.NaN);
        robot.setMotorSpeed(Joint.NECK_PITCH, Double.NEGATIVE_INFINITY);
        step(3);

        assertThat(robot.jointDegrees(Joint.NECK_YAW)).isCloseTo(0, within(0.1));
        assertThat(robot.jointDegrees(Joint.NECK_PITCH)).isCloseTo(-351.77 * 0.06, within(0.1));
    }

    @Test
    void anklesOfTypeTwoHaveSpeedsOfTheirOwn() {
        Robot quick = world.addRobot(RobotType.TYPE_2);
        quick.moveTo(new Vector3(5, 0, 500));
        quick.setMotorSpeed(Joint.LEFT_FOOT_PITCH, 100);
        quick.setMotorSpeed(Joint.LEFT_FOOT_ROLL, -100);
        step(5);

        assertThat(quick.jointDegrees(Joint.LEFT_FOOT_PITCH)).isCloseTo(Math.toDegrees(0.880667), within(0.3));
        assertThat(quick.jointDegrees(Joint.LEFT_FOOT_ROLL)).isCloseTo(-Math.toDegrees(0.347234), within(0.3));
    }

    /** Goes quickly most of the way and slowly against the stop. */
    private void drive(Joint joint, double direction) {
        double end = direction > 0 ? joint.maxDegrees() : joint.minDegrees();
        for (int i = 0; i < 200; i++) {
            boolean near = Math.abs(end - robot.jointDegrees(joint)) < 10;
            robot.setMotorSpeed(joint, direction * (near ? SLOW : FAST));
            world.step();
        }
    }

    private void step(int count) {
        for (int i = 0; i < count; i++) {
            world.step();
        }
    }
}
