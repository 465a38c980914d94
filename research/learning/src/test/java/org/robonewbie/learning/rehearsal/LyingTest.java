package org.robonewbie.learning.rehearsal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LyingTest {

    @ParameterizedTest
    @EnumSource
    void robotsFallOnTheSideThatIsWanted(Lying lying) {
        try (Rehearsal robot = lying.fallen(1)) {
            double height = robot.body().position().z();
            robot.hold(0.2);

            assertThat(lying.isTrueOf(robot.body())).isTrue();
            assertThat(height).isLessThan(0.2);
            assertThat(robot.body().position().z()).isCloseTo(height, within(0.005));
        }
    }

    @ParameterizedTest
    @EnumSource
    void standingIsNotLying(Lying lying) {
        try (Rehearsal robot = Rehearsal.inStance(1, 0)) {
            assertThat(lying.isTrueOf(robot.body())).isFalse();
        }
    }
}
