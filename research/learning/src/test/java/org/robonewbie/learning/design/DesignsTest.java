package org.robonewbie.learning.design;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.nao.motion.MotionFile;

class DesignsTest {

    @ParameterizedTest
    @MethodSource("names")
    void makesMotionsThatTheRobotCanDo(String name) {
        MotionDesign design = Designs.named(name);

        List<DescribedMotion> motions = design.motions(design.start());

        assertThat(motions).isNotEmpty();
        for (DescribedMotion described : motions) {
            MotionFile file = MotionFile.of(described.motion());
            assertThat(file.warnings()).as(described.motion().name()).isEmpty();
        }
    }

    @Test
    void mirrorsNameAndWordsWithTheMovement() {
        List<DescribedMotion> motions = Designs.named("turn-left").motions(new double[] {0});

        assertThat(motions.get(1).motion().name()).isEqualTo("turn-right");
        assertThat(motions.get(1).does()).isEqualTo("turns by 30 degrees to the right on the spot");
        assertThat(motions.get(1).motion().keyframes())
                .isEqualTo(motions.get(0).motion().mirrored().keyframes());
    }

    @Test
    void namesADesignThatIsMissing() {
        assertThatThrownBy(() -> Designs.named("fly"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("There is no design \"fly\". Known are: [dance, ");
    }

    static List<String> names() {
        return Designs.names();
    }
}
