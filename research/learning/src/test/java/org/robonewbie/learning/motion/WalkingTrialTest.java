package org.robonewbie.learning.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;

class WalkingTrialTest {

    private static final WalkStyle STYLE = WalkStyle.STANDARD;

    @Test
    void walksAsFastAsItIsTold() {
        double speed = 0.8 * STYLE.most().forward();
        try (MotionTrial robot = MotionTrial.inStance(5, 0)) {
            robot.walk(() -> new WalkVelocity(speed, 0, 0), () -> robot.seconds() < 8);

            assertThat(robot.forward() / 8).isCloseTo(speed, within(0.25 * speed));
            assertThat(Math.abs(robot.turnedDegrees())).isLessThan(10);
            assertThat(robot.stopWalking() && robot.endsInStance()).isTrue();
        }
    }

    @Test
    void turnsToTheLeftOnTheSpot() {
        try (MotionTrial robot = MotionTrial.inStance(5, 0)) {
            robot.walk(() -> new WalkVelocity(0, 0, 45), () -> robot.seconds() < 4);

            assertThat(robot.turnedDegrees()).isCloseTo(180, within(45.0));
            assertThat(Math.hypot(robot.forward(), robot.left())).isLessThan(0.15);
            assertThat(robot.stopWalking() && robot.endsInStance()).isTrue();
        }
    }

    @Test
    void staysOnItsFeetWhateverItIsToldAndDoesTheSameForTheSameSeed() {
        double forward = erraticWalk();

        assertThat(erraticWalk()).isEqualTo(forward);
    }

    private static double erraticWalk() {
        try (MotionTrial robot = MotionTrial.inStance(3, 3)) {
            robot.walk(new ErraticVelocities(STYLE, 3), () -> robot.seconds() < 10);
            assertThat(robot.stopWalking() && robot.endsInStance()).isTrue();
            return robot.forward();
        }
    }
}
