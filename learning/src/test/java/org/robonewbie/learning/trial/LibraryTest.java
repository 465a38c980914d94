package org.robonewbie.learning.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.motion.Motion;

class LibraryTest {

    @Test
    void standLeadsToTheStance() {
        Motion stand = Library.motion("stand");

        assertThat(stand.keyframes().get(stand.keyframes().size() - 1).posture())
                .isEqualTo(Stance.POSTURE);
    }

    @Test
    void namesAMotionThatIsMissing() {
        assertThatThrownBy(() -> Library.motion("fly"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("There is no shipped motion \"fly\".");
    }
}
