package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
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
            Moment beginning = trial.now();
            trial.run(2);

            trial.reset(1, kick());

            assertThat(trial.seconds()).isZero();
            assertThat(trial.now().ball()).isEqualTo(beginning.ball());
            assertThat(trial.now().robot().torso()).isEqualTo(beginning.robot().torso());
        }
    }

    private static Performer kick() {
        return Performer.ofMotion(ShippedMotions.motion("kick-left"));
    }

    private static List<String> run(Trial trial) {
        List<String> states = new ArrayList<>();
        while (trial.seconds() < 3) {
            Moment moment = trial.step();
            states.add(moment.ball() + " " + moment.robot().torso());
        }
        return states;
    }
}
