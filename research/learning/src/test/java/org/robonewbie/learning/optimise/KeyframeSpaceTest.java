package org.robonewbie.learning.optimise;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

class KeyframeSpaceTest {

    @ParameterizedTest
    @ValueSource(strings = {"kick-right", "walk-forward", "stand-up-from-back", "wave"})
    void nothingChangedIsTheMotionItself(String name) {
        Motion motion = ShippedMotions.motion(name);
        KeyframeSpace space = new KeyframeSpace(motion);

        assertThat(space.motion(new double[space.dimension()])).isEqualTo(motion);
    }

    @Test
    void allIsWithinTheJointsRanges() {
        Motion changed = changed("kick-right", 50);

        for (Keyframe keyframe : changed.keyframes()) {
            assertThat(keyframe.posture().clamped()).isEqualTo(keyframe.posture());
            assertThat(keyframe.durationMillis() % 20).isZero();
        }
        assertThat(changed("kick-right", -50).keyframes().get(0).durationMillis())
                .isEqualTo(40);
    }

    @Test
    void theLastKeyframeStays() {
        Motion motion = ShippedMotions.motion("kick-right");
        int last = motion.keyframes().size() - 1;

        assertThat(changed("kick-right", 1).keyframes().get(last))
                .isEqualTo(motion.keyframes().get(last));
        assertThat(changed("kick-right", 1).keyframes().get(0))
                .isNotEqualTo(motion.keyframes().get(0));
    }

    @Test
    void theTwoStepsOfAWalkStayMirrorImages() {
        List<Keyframe> steps = changed("walk-forward", 1).keyframes();
        int half = steps.size() / 2;

        for (int i = 0; i < half; i++) {
            assertThat(steps.get(i + half).posture())
                    .isEqualTo(steps.get(i).posture().mirrored());
        }
        assertThat(steps).isNotEqualTo(ShippedMotions.motion("walk-forward").keyframes());
    }

    @Test
    void symmetricalPosturesStaySymmetrical() {
        Keyframe first = changed("stand-up-from-back", 1).keyframes().get(0);

        assertThat(first.posture()).isEqualTo(first.posture().mirrored());
    }

    @Test
    void theHeadIsLeftOut() {
        Keyframe first = changed("kick-right", 1).keyframes().get(0);

        assertThat(first.posture().degrees(Joint.NECK_YAW)).isZero();
    }

    private static Motion changed(String name, double by) {
        KeyframeSpace space = new KeyframeSpace(ShippedMotions.motion(name));
        double[] coordinates = new double[space.dimension()];
        Arrays.fill(coordinates, by);
        return space.motion(coordinates);
    }
}
