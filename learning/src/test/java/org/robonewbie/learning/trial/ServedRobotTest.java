package org.robonewbie.learning.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

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

    @Test
    void knowsThatItHasFallen() {
        try (ServedRobot robot = new ServedRobot(4)) {
            robot.perform("fall-back");

            assertThat(robot.endsStanding()).isFalse();
            assertThat(robot.uprightness()).isLessThan(0.5);
        }
    }
}
