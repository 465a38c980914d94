package org.robonewbie.learning.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Distance;

class MotionTrialTest {

    @Test
    void isTheSameEachTimeForTheSameSeed() {
        WorldState first = walked(7);
        WorldState other = walked(8);
        WorldState second = walked(7);

        assertThat(second.robot().torso()).isEqualTo(first.robot().torso());
        assertThat(other.robot().torso()).isNotEqualTo(first.robot().torso());
    }

    @Test
    void beginsInTheStance() {
        try (MotionTrial robot = MotionTrial.inStance(3, 0)) {
            assertThat(robot.isInStance()).isTrue();
            assertThat(robot.forward()).isZero();
            assertThat(robot.seconds()).isZero();
            assertThat(robot.endsInStance()).isTrue();
            assertThat(robot.seconds()).isCloseTo(0.6, within(1e-9));
        }
    }

    @Test
    void placesTheBallAsTheRobotSeesIt() {
        try (MotionTrial robot = MotionTrial.inStance(3, 0)) {
            robot.placeBall(new Translation2d(0.2, 0.05), 1);

            assertThat(robot.start().ahead(robot.trial().now().ball())).isCloseTo(0.2, within(0.01));
            assertThat(robot.start().left(robot.trial().now().ball())).isCloseTo(0.05, within(0.01));
        }
    }

    @Test
    void showsEachCycleToItsGuests() {
        try (MotionTrial robot = MotionTrial.inStance(3, 0)) {
            Distance distance = new Distance();
            robot.watch(distance);

            robot.play(ShippedMotions.motion("walk-forward"));

            assertThat(distance.value()).isPositive().isEqualTo(robot.forward());
            assertThat(robot.balance().value()).isBetween(1.0, 60.0);
        }
    }

    @Test
    void breaksOffWhenTheRobotFalls() {
        try (MotionTrial robot = MotionTrial.inStance(3, 0)) {
            robot.trial().with(trial -> trial.robot(0).push(new Vector3(-60, 0, 0)));

            boolean done = robot.hold(3);

            assertThat(done).isFalse();
            assertThat(robot.seconds()).isLessThan(3);
            assertThat(robot.balance().hasFallen()).isTrue();
            assertThat(robot.play(ShippedMotions.motion("bow"))).isFalse();
        }
    }

    private static WorldState walked(long seed) {
        try (MotionTrial robot = MotionTrial.inStance(seed, 5)) {
            Motion walk = ShippedMotions.motion("walk-forward");
            robot.play(walk);
            robot.play(walk);
            return robot.trial().now();
        }
    }
}
