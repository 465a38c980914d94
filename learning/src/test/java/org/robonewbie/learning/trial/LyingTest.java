package org.robonewbie.learning.trial;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LyingTest {

    @ParameterizedTest
    @EnumSource
    void robotsFallOnTheSideThatIsWanted(Lying lying) {
        TrialRobot robot = lying.fallen(1);

        assertThat(lying.isTrueOf(robot)).isTrue();
        assertThat(robot.torso().z()).isLessThan(0.2);
        assertThat(robot.velocity().length()).isLessThan(0.1);
    }

    @ParameterizedTest
    @EnumSource
    void standingIsNotLying(Lying lying) {
        assertThat(lying.isTrueOf(new TrialRobot())).isFalse();
    }
}
