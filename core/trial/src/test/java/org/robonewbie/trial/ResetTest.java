package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.file.ShippedMotions;

class ResetTest {

    private final Scene scene = Scene.of(RobotStart.at(-2, 0).after("stand")).withBall(-1.8, 0.04);

    @Test
    void resetTrialRunsAsANewOne() {
        try (Trial trial = Trial.direct(scene, 1, kick());
                Trial other = Trial.direct(scene, 1, kick())) {
            trial.run(2);
            trial.reset(1, kick());

            assertThat(run(trial)).isEqualTo(run(other));
        }
    }

    @Test
    void resetTrialIsAtItsBeginning() {
        try (Trial trial = Trial.direct(scene, 1, kick())) {
            WorldState beginning = trial.now();
            trial.run(2);

            trial.reset(1, kick());

            assertThat(trial.seconds()).isZero();
            assertThat(trial.now().ball()).isEqualTo(beginning.ball());
            assertThat(trial.now().robot().torso()).isEqualTo(beginning.robot().torso());
        }
    }

    @Test
    void resetReturnsToTheMomentThatWasKept() {
        try (Trial trial = Trial.direct(scene, 1, kick())) {
            trial.run(2);
            WorldState kept = trial.now();
            trial.keep();
            trial.run(1);

            trial.reset(1, Controller.ofSpeeds());

            assertThat(trial.seconds()).isZero();
            assertThat(trial.now().ball()).isEqualTo(kept.ball());
            assertThat(trial.now().robot().torso()).isEqualTo(kept.robot().torso());
        }
    }

    private static Controller kick() {
        return Controller.ofMotion(ShippedMotions.motion("kick-left"));
    }

    private static List<String> run(Trial trial) {
        List<String> states = new ArrayList<>();
        while (trial.seconds() < 3) {
            WorldState state = trial.step();
            states.add(state.ball() + " " + state.robot().torso());
        }
        return states;
    }

    @Test
    void gripAndMassChangeUntilTheTrialIsReset() {
        try (Trial trial = Trial.direct(Scene.of(RobotStart.at(0, 0)), 1, Controller.ofSpeeds())) {
            double usual = slide(trial);

            trial.reset(1, Controller.ofSpeeds());
            trial.setGrip(0.1);
            double slippery = slide(trial);
            trial.reset(1, Controller.ofSpeeds());
            trial.robot(0).setMassFactor(2);
            double heavy = slide(trial);
            trial.reset(1, Controller.ofSpeeds());

            assertThat(slippery).isGreaterThan(2 * usual);
            assertThat(heavy).isNotEqualTo(usual);
            assertThat(slide(trial)).isEqualTo(usual);
        }
    }

    /** How far a gentle push moves a robot to the side in a second. */
    private static double slide(Trial trial) {
        double before = trial.now().robot().position().y();
        for (int i = 0; i < 50; i++) {
            trial.robot(0).push(new Vector3(0, 4, 0));
            trial.step();
        }
        return trial.now().robot().position().y() - before;
    }
}
