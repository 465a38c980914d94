package org.robonewbie.learning.motion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

class StanceTest {

    @Test
    void standLeadsToTheStance() {
        Motion stand = ShippedMotions.motion("stand");

        assertThat(stand.keyframes().get(stand.keyframes().size() - 1).posture())
                .isEqualTo(Stance.POSTURE);
    }
}
