package org.robonewbie.learning.design;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;

class SketchTest {

    private final Sketch sketch =
            Sketch.load("stand-up-from-back", joint -> !joint.name().startsWith("NECK_"));

    @Test
    void isItselfWithoutChanges() {
        Motion motion = sketch.motion(sketch.coordinates());

        Keyframe last = motion.keyframes().get(motion.keyframes().size() - 1);
        assertThat(last.posture()).isEqualTo(Stance.POSTURE);
        assertThat(motion.keyframes().get(0).durationMillis()).isEqualTo(800);
    }

    @Test
    void keepsSymmetricPosturesSymmetric() {
        double[] coordinates = sketch.coordinates();
        for (int i = 0; i < coordinates.length; i++) {
            coordinates[i] += 0.3 * Math.sin(i);
        }

        Motion motion = sketch.motion(coordinates);

        assertThat(motion.keyframes())
                .allSatisfy(keyframe -> assertThat(keyframe.posture())
                        .isEqualTo(keyframe.posture().mirrored()));
    }

    @Test
    void staysWithinTheJointsRanges() {
        double[] coordinates = sketch.coordinates();
        coordinates[2] = 100;

        Motion motion = sketch.motion(coordinates);

        assertThat(motion.keyframes().get(0).posture())
                .isEqualTo(motion.keyframes().get(0).posture().clamped());
        assertThat(sketch.degreesBeyondRange(coordinates)).isGreaterThan(800);
    }

    @Test
    void namesASketchThatIsMissing() {
        assertThatThrownBy(() -> Sketch.load("fly", joint -> true))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("There is no sketch \"fly\".");
    }
}
