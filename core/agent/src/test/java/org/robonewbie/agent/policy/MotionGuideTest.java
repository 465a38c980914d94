package org.robonewbie.agent.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

class MotionGuideTest {

    private static final Posture UP = Posture.ZERO.with(Joint.LEFT_SHOULDER_PITCH, 40);
    private static final Motion NOD =
            new Motion("nod", List.of(new Keyframe(100, UP), new Keyframe(60, UP.with(Joint.NECK_PITCH, -30))));

    private final MotionGuide guide = new MotionGuide(NOD, Posture.ZERO.with(Joint.LEFT_SHOULDER_PITCH, -60));

    @Test
    void leadsFromTheFirstPostureThroughAllKeyframesAndStays() {
        assertThat(guide.posture(0).degrees(Joint.LEFT_SHOULDER_PITCH)).isEqualTo(-60);
        assertThat(guide.posture(1).degrees(Joint.LEFT_SHOULDER_PITCH)).isCloseTo(-40, within(1e-9));
        assertThat(guide.posture(5)).isEqualTo(UP);
        assertThat(guide.posture(6).degrees(Joint.NECK_PITCH)).isCloseTo(-10, within(1e-9));
        assertThat(guide.posture(8).degrees(Joint.NECK_PITCH)).isEqualTo(-30);
        assertThat(guide.posture(1000)).isEqualTo(guide.posture(8));
    }

    @Test
    void saysHowFarTheMotionHasGot() {
        assertThat(guide.progress(0)).hasSize(MotionGuide.PROGRESS.size()).containsExactly(0, 1, 0, 1, 0, 1);
        assertThat(guide.progress(4)[0]).isEqualTo(1);
        assertThat(guide.progress(9)).isEqualTo(guide.progress(8));
        assertThat(guide.isOver(7)).isFalse();
        assertThat(guide.isOver(8)).isTrue();
    }

    @Test
    void motionTravelsAsNumbersOfAPolicy() {
        double[] numbers = MotionGuide.numbers(NOD).stream()
                .mapToDouble(Double::doubleValue)
                .toArray();

        assertThat(MotionGuide.motion("nod", numbers)).isEqualTo(NOD);
        assertThatThrownBy(() -> MotionGuide.motion("nod", 100, 1))
                .hasMessage("A motion of 2 numbers contains an incomplete keyframe; each has 23 numbers.");
    }
}
