package org.robonewbie.studio.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import org.junit.jupiter.api.Test;
import org.robonewbie.studio.file.RefusedException;

class PhysicalTrialTest {

    private static final String STANCE = " 0 0 -95 10 -90 -40 0 0 35 -70 37 0 0 0 35 -70 37 0 -95 -10 90 40\n";

    @Test
    void playsAFileByTheRuleThatItNames() {
        String skipped = "400" + STANCE + "20" + STANCE.replace(" 0 0 -95", " 30 0 -95") + "40" + STANCE;

        String usual = PhysicalTrial.json(skipped, "standing");

        assertThat(PhysicalTrial.json("// author: Ada\n" + skipped, "standing")).isEqualTo(usual);
        assertThat(PhysicalTrial.json("// play: 1.1\n" + skipped, "standing")).isNotEqualTo(usual);
    }

    @Test
    void refusesInvalidMotions() {
        assertThatExceptionOfType(RefusedException.class)
                .isThrownBy(() -> PhysicalTrial.json("400 1 2\n", "standing"))
                .withMessageContaining("line 1");
    }
}
