package org.robonewbie.learning.design;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.learning.rehearsal.KickTrial;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

class KickSwingTest {

    private static final Motion KICK = ShippedMotions.motion("far-kick-right");
    private static final BallPlace BALL =
            ShippedMotions.file("far-kick-right").ball().orElseThrow();

    @Test
    void aSwingIntoTheAirTellsHowFarABallWouldGet() {
        KickSwing swing = KickSwing.of(RobotType.TYPE_0, KICK, 1);

        KickSwing.Shot shot = swing.shot(new BallPlace(BALL.ahead() + 0.01, BALL.left()));

        KickTrial trial = KickTrial.quick(KICK, BALL, 1);
        assertThat(shot.ahead()).isCloseTo(trial.metres(), within(0.2 * trial.metres()));
        assertThat(Math.toDegrees(Math.atan2(shot.left(), shot.ahead()))).isCloseTo(trial.degreesAside(), within(5.0));
    }

    @Test
    void aBallOutOfReachStaysWhereItIs() {
        KickSwing swing = KickSwing.of(RobotType.TYPE_0, KICK, 1);

        assertThat(swing.shot(new BallPlace(0.6, 0))).isEqualTo(KickSwing.Shot.NONE);
    }

    @Test
    void seesThatTheRobotStandsAtTheEnd() {
        assertThat(KickSwing.of(RobotType.TYPE_0, KICK, 1).standing()).isTrue();
        assertThat(KickSwing.of(RobotType.TYPE_0, ShippedMotions.motion("fall-forward"), 1)
                        .standing())
                .isFalse();
    }
}
