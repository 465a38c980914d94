package org.robonewbie.workshop.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.model.RobotType;

class MotionMeasurementTest {

    @Test
    void eachCheckSaysHowItBeginsWhatCountsAndInWhichUnit() {
        List<MotionCheck> checks = MotionMeasurement.checks();

        assertThat(checks).extracting(MotionCheck::name).doesNotHaveDuplicates();
        assertThat(checks).allSatisfy(check -> {
            assertThat(check.start()).isNotBlank();
            assertThat(check.rule()).isNotBlank();
            assertThat(check.unit()).isNotBlank();
        });
    }

    @Test
    void averagesTheSuccessfulTrials() {
        MotionCheck check = new MotionCheck("jump", "stance", "flies", "m", seed -> new Outcome(seed % 2 == 0, seed));

        CheckResult result = CheckResult.of(check, 0, 5);

        assertThat(result.successes()).isEqualTo(3);
        assertThat(result.mean()).isEqualTo(2);
    }

    @Test
    void refusesToMeasureWithoutTrials() {
        assertThatThrownBy(() -> new MotionMeasurement(0, 1, "", RobotType.TYPE_0, System.out))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Cannot measure with 0 seeds. Use at least 1.");
    }

    @Test
    void countsOnFromItsFirstSeed() {
        MotionCheck check = new MotionCheck("jump", "stance", "flies", "m", seed -> new Outcome(true, seed));

        assertThat(CheckResult.of(check, 21, 3).outcomes())
                .extracting(Outcome::value)
                .containsExactly(21.0, 22.0, 23.0);
    }

    @Test
    void refusesAPartThatNoNameHas() {
        assertThatThrownBy(
                        () -> new MotionMeasurement(1, 0, "flight", RobotType.TYPE_0, System.out).run(Optional.empty()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("No motion name contains \"flight\".");
    }
}
