package org.robonewbie.agent.walk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class PoseApproachTest {

    private final PoseApproach approach = new PoseApproach(WalkStyle.STANDARD);

    @Test
    void walksForwardAsFastAsItCanToAPlaceFarAhead() {
        WalkVelocity velocity = approach.velocity(3, 0, 90);

        assertThat(velocity.forward()).isCloseTo(WalkStyle.STANDARD.most().forward(), within(1e-9));
        assertThat(velocity.turn()).isZero();
    }

    @Test
    void turnsOnTheSpotToAPlaceFarBehind() {
        WalkVelocity velocity = approach.velocity(-3, 0.1, 0);

        assertThat(velocity.forward()).isZero();
        assertThat(velocity.turn()).isEqualTo(WalkStyle.STANDARD.most().turn());
    }

    @Test
    void turnsToTheWantedHeadingNearThePlace() {
        assertThat(approach.velocity(0.1, 0, 40).turn()).isPositive();
        assertThat(approach.velocity(0.1, 0, -40).turn()).isNegative();
    }

    @Test
    void slowsDownBeforeThePlace() {
        double far = approach.velocity(0.5, 0, 0).forward();
        double near = approach.velocity(0.1, 0, 0).forward();

        assertThat(near).isPositive().isLessThan(far);
    }

    @Test
    void stepsAsideNearThePlace() {
        assertThat(approach.velocity(0, -0.1, 0).left()).isNegative();
    }

    @Test
    void standsStillAtThePlace() {
        assertThat(approach.velocity(0, 0, 0)).isEqualTo(WalkVelocity.ZERO);
    }
}
