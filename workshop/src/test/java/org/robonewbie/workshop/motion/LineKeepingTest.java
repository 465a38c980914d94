package org.robonewbie.workshop.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.localisation.GroundPose;

class LineKeepingTest {

    private static final GroundPose LINE = new GroundPose(1, 2, 90);

    @Test
    void turnsNowhereOnTheLine() {
        assertThat(LineKeeping.FIRM.turn(LINE, new GroundPose(1, 7, 90))).isEqualTo(0, within(1e-9));
    }

    @Test
    void turnsBackToTheLine() {
        GroundPose leftOfTheLine = new GroundPose(0.9, 7, 90);

        assertThat(LineKeeping.FIRM.turn(LINE, leftOfTheLine)).isEqualTo(-8, within(1e-9));
    }

    @Test
    void turnsNoFasterThanItMay() {
        assertThat(LineKeeping.GENTLE.turn(LINE, new GroundPose(1, 2, -170))).isEqualTo(-10);
    }
}
