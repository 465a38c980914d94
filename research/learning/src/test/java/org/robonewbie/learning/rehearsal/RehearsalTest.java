package org.robonewbie.learning.rehearsal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Distance;

class RehearsalTest {

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
        try (Rehearsal robot = Rehearsal.inStance(3, 0)) {
            assertThat(robot.isInStance()).isTrue();
            assertThat(robot.forward()).isZero();
            assertThat(robot.seconds()).isZero();
            assertThat(robot.endsInStance()).isTrue();
            assertThat(robot.seconds()).isCloseTo(0.6, within(1e-9));
        }
    }

    @Test
    void placesTheBallAsTheRobotSeesIt() {
        try (Rehearsal robot = Rehearsal.inStance(3, 0)) {
            robot.placeBall(new BallPlace(0.2, 0.05), 1);

            assertThat(robot.start().ahead(robot.now().ball())).isCloseTo(0.2, within(0.01));
            assertThat(robot.start().left(robot.now().ball())).isCloseTo(0.05, within(0.01));
        }
    }

    @Test
    void showsEachCycleToItsGuests() {
        try (Rehearsal robot = Rehearsal.inStance(3, 0)) {
            Distance distance = new Distance();
            robot.watch(distance);

            robot.play(ShippedMotions.motion("walk-forward"));

            assertThat(distance.value()).isPositive().isEqualTo(robot.forward());
            assertThat(robot.poise().meanRocking()).isBetween(1.0, 60.0);
        }
    }

    @Test
    void breaksOffWhenTheRobotFalls() {
        try (Rehearsal robot = Rehearsal.inStance(3, 0)) {
            robot.with(trial -> trial.robot(0).push(new Vector3(-60, 0, 0)));

            boolean done = robot.hold(3);

            assertThat(done).isFalse();
            assertThat(robot.seconds()).isLessThan(3);
            assertThat(robot.poise().hasFallen()).isTrue();
            assertThat(robot.play(ShippedMotions.motion("bow"))).isFalse();
        }
    }

    @Test
    void agentWalksAndTurnsAsItIsTold() {
        try (Rehearsal robot = Rehearsal.served(4, RobotType.TYPE_0)) {
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
        try (Rehearsal robot = Rehearsal.served(4, type)) {
            walk(robot, new WalkVelocity(0.4, 0, 0), 1);

            assertThat(robot.endsInStance()).isTrue();
            assertThat(robot.forward()).isBetween(1.0, 1.5);
            assertThat(robot.turnedDegrees()).isCloseTo(0, within(10.0));
        }
    }

    private static void walk(Rehearsal robot, WalkVelocity velocity, double metres) {
        robot.walk(() -> velocity, () -> robot.forward() < metres);
        robot.stopWalking();
    }

    private static WorldState walked(long seed) {
        try (Rehearsal robot = Rehearsal.inStance(seed, 5)) {
            Motion walk = ShippedMotions.motion("walk-forward");
            robot.play(walk);
            robot.play(walk);
            return robot.now();
        }
    }
}
