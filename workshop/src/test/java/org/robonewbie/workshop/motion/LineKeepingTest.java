package org.robonewbie.workshop.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.geometry.Pose2d;

class LineKeepingTest {

    private static final Pose2d LINE = new Pose2d(1, 2, 90);

    @Test
    void turnsNowhereOnTheLine() {
        assertThat(LineKeeping.FIRM.turn(LINE, new Pose2d(1, 7, 90))).isEqualTo(0, within(1e-9));
    }

    @Test
    void turnsBackToTheLine() {
        Pose2d leftOfTheLine = new Pose2d(0.9, 7, 90);

        assertThat(LineKeeping.FIRM.turn(LINE, leftOfTheLine)).isEqualTo(-8, within(1e-9));
    }

    @Test
    void turnsNoFasterThanItMay() {
        assertThat(LineKeeping.GENTLE.turn(LINE, new Pose2d(1, 2, -170))).isEqualTo(-10);
    }
}
