package org.robonewbie.learning.design;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

class LimbOverlapTest {

    private final LimbOverlap limbs = new LimbOverlap(NaoModel.of(RobotType.TYPE_0));

    @Test
    void thereIsNoneInTheStance() {
        assertThat(limbs.metres(poses(Stance.POSTURE))).isZero();
    }

    @Test
    void legsThatCrossAreInEachOther() {
        Posture crossed = Stance.POSTURE.with(Joint.LEFT_HIP_ROLL, -20).with(Joint.RIGHT_HIP_ROLL, 20);

        assertThat(limbs.metres(poses(crossed))).isBetween(0.03, 0.3);
    }

    @Test
    void isTheSameInTheMirror() {
        Posture turned = Stance.POSTURE.with(Joint.RIGHT_HIP_ROLL, 25).with(Joint.RIGHT_KNEE_PITCH, -90);

        assertThat(limbs.metres(poses(turned)))
                .isPositive()
                .isCloseTo(limbs.metres(poses(turned.mirrored())), within(1e-9));
    }

    private static Function<String, Pose> poses(Posture posture) {
        return BodyState.of(RobotType.TYPE_0, Pose.ORIGIN, posture).limbs()::link;
    }
}
