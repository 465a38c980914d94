package org.robonewbie.learning.rehearsal;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

class FallenRobotTest {

    private final Motion motion = ShippedMotions.motion("stand-up-from-back");

    @Test
    void liesInTheSameWayForEachTrial() {
        FallenRobot robot = FallenRobot.anyhow(Lying.ON_BACK, RobotType.TYPE_1, 3);

        GetUpTrial first = robot.getUp(motion, 1, 1, 1);
        GetUpTrial usual = robot.getUp(motion, 1, 0, 1);

        assertThat(robot.getUp(motion, 1, 1, 1)).isEqualTo(first).isNotEqualTo(usual);
        assertThat(usual.success()).isTrue();
        assertThat(robot.lies(Lying.ON_BACK)).isTrue();
    }

    @Test
    void fallsByAMotion() {
        FallenRobot robot = FallenRobot.after(RobotType.TYPE_0, "fall-forward", 1);

        assertThat(robot.lies(Lying.ON_FRONT)).isTrue();
        assertThat(robot.lies(Lying.ON_BACK)).isFalse();
    }
}
