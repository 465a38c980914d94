package org.robonewbie.agent.walk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Leg;

class ResidualPolicyTest {

    private static final int[] LAYERS = {ResidualPolicy.INPUTS.size(), ResidualPolicy.OUTPUTS.size()};

    private final Random random = new Random(3);
    private final ResidualPolicy reflex = new ResidualPolicy(
            Network.of(LAYERS, random.doubles(Network.size(LAYERS), -0.5, 0.5).toArray()));

    @Test
    void answersTheMirrorImageByTheMirrorImage() {
        FootPressure left = new FootPressure(new Vector3(0.01, 0.02, 0), new Vector3(0, 0, 10));
        FootPressure right = new FootPressure(new Vector3(-0.02, 0.01, 0), new Vector3(0, 0, 30));
        WalkVelocity wanted = new WalkVelocity(0.3, 0.1, 20);
        WalkMoment moment = new WalkMoment(Leg.LEFT, 0.3, 1, wanted, wanted, 2, 30, 4, 50, 60, left, right);
        WalkVelocity other = new WalkVelocity(0.3, -0.1, -20);
        WalkMoment mirrored =
                new WalkMoment(Leg.RIGHT, 0.3, 1, other, other, 2, 30, -4, -50, -60, mirrored(right), mirrored(left));

        assertThat(reflex.corrected(Stance.POSTURE, mirrored)
                        .largestDifference(
                                reflex.corrected(Stance.POSTURE, moment).mirrored()))
                .isLessThan(1e-9);
        assertThat(reflex.corrected(Stance.POSTURE, moment).largestDifference(Stance.POSTURE))
                .isGreaterThan(1);
    }

    @Test
    void doesNothingBeforeTheFirstStep() {
        WalkVelocity wanted = new WalkVelocity(0.3, 0, 0);
        WalkMoment moment =
                new WalkMoment(Leg.LEFT, 0, 0, wanted, wanted, 9, 9, 9, 9, 9, FootPressure.NONE, FootPressure.NONE);

        assertThat(reflex.corrected(Stance.POSTURE, moment)).isEqualTo(Stance.POSTURE);
    }

    private static FootPressure mirrored(FootPressure foot) {
        return new FootPressure(new Vector3(foot.point().x(), -foot.point().y(), 0), foot.force());
    }
}
