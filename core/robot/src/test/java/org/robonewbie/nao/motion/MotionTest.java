package org.robonewbie.nao.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.Joint;

class MotionTest {

    private static final Posture FIRST = Posture.ZERO.with(Joint.NECK_YAW, 10);
    private static final Posture SECOND = Posture.ZERO.with(Joint.NECK_YAW, 20);
    private static final Posture THIRD = Posture.ZERO.with(Joint.NECK_YAW, 30);
    private static final Motion MOTION =
            new Motion("look", List.of(new Keyframe(100, FIRST), new Keyframe(200, SECOND), new Keyframe(300, THIRD)));

    @Test
    void lastsAsLongAsItsKeyframes() {
        assertThat(MOTION.durationMillis()).isEqualTo(600);
    }

    @Test
    void getsAnotherName() {
        assertThat(MOTION.named("gaze")).isEqualTo(new Motion("gaze", MOTION.keyframes()));
    }

    @Test
    void isStretchedInWholeCycles() {
        assertThat(MOTION.stretched(1.25).keyframes())
                .containsExactly(new Keyframe(120, FIRST), new Keyframe(260, SECOND), new Keyframe(380, THIRD));
        assertThat(MOTION.stretched(0.01).keyframes())
                .extracting(Keyframe::durationMillis)
                .containsExactly(20, 20, 20);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void refusesToBeStretchedByNonsense(double factor) {
        assertThatThrownBy(() -> MOTION.stretched(factor))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Cannot stretch a motion by the factor " + factor + ". Use a positive number such as 2.0.");
    }

    @Test
    void mirrorsEachKeyframe() {
        Motion mirrored = MOTION.mirrored();

        assertThat(mirrored.keyframes().get(2)).isEqualTo(new Keyframe(300, THIRD.with(Joint.NECK_YAW, -30)));
        assertThat(mirrored.mirrored()).isEqualTo(MOTION);
    }
}
