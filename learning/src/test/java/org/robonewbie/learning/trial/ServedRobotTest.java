package org.robonewbie.learning.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.model.RobotType;

class ServedRobotTest {

    @Test
    void walksAndTurnsWhereItsAgentWantsTo() {
        try (ServedRobot robot = new ServedRobot(4)) {
            robot.walk(0.3, 0, 0, () -> robot.forward() > 0.5);
            double forward = robot.forward();
            robot.walk(0, 0, 45, () -> robot.turnedDegrees() > 45);

            assertThat(forward).isCloseTo(0.6, within(0.15));
            assertThat(robot.turnedDegrees()).isCloseTo(50, within(15.0));
            assertThat(robot.endsStanding()).isTrue();
        }
    }

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void walksOnLegsOfAnyLength(RobotType type) {
        try (ServedRobot robot = new ServedRobot(4, type)) {
            robot.walk(0.4, 0, 0, () -> robot.forward() > 1);

            assertThat(robot.endsStanding()).isTrue();
            assertThat(robot.forward()).isBetween(1.0, 1.5);
            assertThat(robot.turnedDegrees()).isCloseTo(0, within(10.0));
        }
    }

    @Test
    void knowsThatItHasFallen() {
        try (ServedRobot robot = new ServedRobot(4)) {
            robot.perform("fall-back");

            assertThat(robot.endsStanding()).isFalse();
            assertThat(robot.uprightness()).isLessThan(0.5);
        }
    }
}
