package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.measure.Distance;

class ControllerTest {

    private static final Scene SCENE = Scene.of(RobotStart.at(-2, 0).after("stand"));

    private static double walked(Controller controller, double seconds) {
        Distance distance = new Distance();
        try (Trial trial = Trial.direct(SCENE, 1, controller)) {
            trial.run(seconds, distance);
        }
        return distance.value();
    }

    @Test
    void walkGoesAhead() {
        assertThat(walked(Controller.ofWalk(0.3, 0, 0), 3)).isGreaterThan(0.3);
    }

    @Test
    void motionEnds() {
        Controller wave = Controller.ofMotion(ShippedMotions.file("wave"));

        try (Trial trial = Trial.direct(SCENE, 1, wave)) {
            assertThat(wave.isFinished()).isFalse();
            trial.run(10);
        }

        assertThat(wave.isFinished()).isTrue();
        assertThat(wave.readsMessages()).isFalse();
    }

    @Test
    void agentThinksInEachCycle() {
        Counting agent = new Counting();
        Controller controller = Controller.ofAgent(agent);

        try (Trial trial = Trial.served(SCENE, 1, controller)) {
            trial.run(0.2);
        }

        assertThat(agent.cycles).isEqualTo(10);
        assertThat(controller.readsMessages()).isTrue();
        assertThat(controller.isFinished()).isFalse();
    }

    /** Counts its cycles. */
    private static final class Counting extends Agent {

        private int cycles;

        @Override
        protected void think() {
            cycles++;
        }
    }

    @Test
    void speedsTurnTheirJoint() {
        double[] speeds = new double[Joint.COUNT];
        speeds[Joint.NECK_YAW.ordinal()] = 50;

        try (Trial trial = Trial.direct(SCENE, 1, Controller.ofSpeeds(speeds))) {
            trial.run(1);

            assertThat(trial.now().robot().degrees(Joint.NECK_YAW)).isBetween(35.0, 52.0);
        }
    }

    @Test
    void speedsThatCannotBeAreRefused() {
        double[] unknown = new double[Joint.COUNT];
        unknown[3] = Double.NaN;

        assertThatThrownBy(() -> Controller.ofSpeeds(1, 2))
                .hasMessageStartingWith("2 joint speeds for a robot with 22");
        try (Trial trial = Trial.direct(SCENE, 1, Controller.ofSpeeds(unknown))) {
            assertThatThrownBy(trial::step).hasMessageStartingWith("Joint speed NaN for " + Joint.values()[3]);
        }
    }

    @Test
    void randomSourceRepeatsItself() {
        RandomSource one = new RandomSource(5);
        RandomSource same = new RandomSource(5);

        assertThat(one.seed()).isEqualTo(5);
        assertThat(one.isSeedOdd()).isTrue();
        assertThat(one.between(2, 3)).isEqualTo(same.between(2, 3)).isBetween(2.0, 3.0);
        assertThat(one.side()).isEqualTo(same.side()).isIn(-1, 1);
        assertThat(one.shuffled(List.of(1, 2, 3, 4)))
                .isEqualTo(same.shuffled(List.of(1, 2, 3, 4)))
                .containsExactlyInAnyOrder(1, 2, 3, 4);
    }
}
