package org.robonewbie.learning.design;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

class KickKeyframesTest {

    private static final Motion KICK = ShippedMotions.motion("kick-right");

    private final KickKeyframes space = new KickKeyframes(KICK, new BallPlace(0.2, -0.05));

    @Test
    void isTheFirstKickWithoutChanges() {
        double[] none = new double[space.dimension()];

        assertThat(space.motion(none)).isEqualTo(KICK);
        assertThat(space.ball(none)).isEqualTo(new BallPlace(0.2, -0.05));
    }

    @Test
    void endsInTheStanceWhateverChanges() {
        double[] much = new double[space.dimension()];
        Arrays.fill(much, 2);

        Motion changed = space.motion(much);

        Keyframe last = changed.keyframes().get(changed.keyframes().size() - 1);
        assertThat(last.posture()).isEqualTo(Stance.POSTURE);
        assertThat(changed.keyframes().get(0).durationMillis())
                .isEqualTo(KICK.keyframes().get(0).durationMillis() + 60);
        assertThat(space.ball(much)).isEqualTo(new BallPlace(0.22, -0.03));
    }

    @Test
    void staysWithinTheJointsRanges() {
        double[] huge = new double[space.dimension()];
        Arrays.fill(huge, 100);

        assertThat(space.motion(huge).keyframes())
                .allSatisfy(keyframe -> assertThat(keyframe.posture())
                        .isEqualTo(keyframe.posture().clamped()));
    }
}
