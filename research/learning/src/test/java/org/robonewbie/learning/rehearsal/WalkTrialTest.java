package org.robonewbie.learning.rehearsal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;

class WalkTrialTest {

    private static final WalkStyle STYLE = WalkStyle.STANDARD;

    @Test
    void walksAsFastAsItIsTold() {
        WalkVelocity velocity = new WalkVelocity(0.8 * STYLE.most().forward(), 0, 0);

        WalkTrial trial = WalkTrial.straight(STYLE, velocity, 8, 5, 0);

        assertThat(trial.stood()).isTrue();
        assertThat(trial.forward() / 8).isCloseTo(velocity.forward(), within(0.25 * velocity.forward()));
        assertThat(Math.abs(trial.turnedDegrees())).isLessThan(10);
    }

    @Test
    void turnsToTheLeftOnTheSpot() {
        WalkTrial trial = WalkTrial.straight(STYLE, new WalkVelocity(0, 0, 45), 4, 5, 0);

        assertThat(trial.stood()).isTrue();
        assertThat(trial.turnedDegrees()).isCloseTo(180, within(45.0));
        assertThat(Math.hypot(trial.forward(), trial.left())).isLessThan(0.15);
    }

    @Test
    void staysOnItsFeetWhateverItIsTold() {
        assertThat(WalkTrial.erratic(STYLE, 15, 3, 3).stood()).isTrue();
    }

    @Test
    void isTheSameEachTimeForTheSameSeed() {
        WalkTrial first = WalkTrial.erratic(STYLE, 3, 8, 3);
        WalkTrial second = WalkTrial.erratic(STYLE, 3, 8, 3);

        assertThat(second.forward()).isEqualTo(first.forward());
        assertThat(second.turnedDegrees()).isEqualTo(first.turnedDegrees());
    }
}
