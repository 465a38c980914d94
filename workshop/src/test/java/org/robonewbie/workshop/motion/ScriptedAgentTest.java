package org.robonewbie.workshop.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.model.RobotType;

class ScriptedAgentTest {

    @Test
    void agentWalksAndTurnsAsItIsTold() {
        try (MotionTrial robot = CheckStart.server(RobotType.TYPE_0).opening().apply(4)) {
            walk(robot, new WalkVelocity(0.3, 0, 0), 0.5);
            double forward = robot.forward();
            robot.walk(() -> new WalkVelocity(0, 0, 45), () -> robot.turnedDegrees() < 45);
            robot.stopWalking();

            assertThat(forward).isCloseTo(0.6, within(0.15));
            assertThat(robot.turnedDegrees()).isCloseTo(50, within(15.0));
            assertThat(robot.endsInStance()).isTrue();
        }
    }

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void agentWalksOnLegsOfAnyLength(RobotType type) {
        try (MotionTrial robot = CheckStart.server(type).opening().apply(4)) {
            walk(robot, new WalkVelocity(0.4, 0, 0), 1);

            assertThat(robot.endsInStance()).isTrue();
            assertThat(robot.forward()).isBetween(1.0, 1.5);
            assertThat(robot.turnedDegrees()).isCloseTo(0, within(10.0));
        }
    }

    private static void walk(MotionTrial robot, WalkVelocity velocity, double metres) {
        robot.walk(() -> velocity, () -> robot.forward() < metres);
        robot.stopWalking();
    }
}
