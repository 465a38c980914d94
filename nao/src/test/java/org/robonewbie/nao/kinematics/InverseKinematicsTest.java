package org.robonewbie.nao.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

class InverseKinematicsTest {

    private static final long SEED = 1;

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void findsAnglesForEveryFootPoseThatALegCanTake(RobotType type) {
        InverseKinematics inverse = new InverseKinematics(type);
        Random random = new Random(SEED);
        int failures = 0;
        for (int i = 0; i < 3000; i++) {
            Leg leg = i % 2 == 0 ? Leg.LEFT : Leg.RIGHT;
            Posture posture = randomPosture(random);
            Pose wanted = ForwardKinematics.of(type).poses(posture).foot(leg);

            LegSolution solution = inverse.solve(leg, wanted);

            failures += solution.isReachable() ? 0 : 1;
            Pose reached =
                    ForwardKinematics.of(type).poses(solution.applyTo(posture)).foot(leg);
            assertThat(reached.position().distanceTo(wanted.position()))
                    .isCloseTo(solution.positionErrorMetres(), within(1e-9));
        }
        assertThat(failures).isZero();
    }

    private static Posture randomPosture(Random random) {
        double[] degrees = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] =
                    joint.minDegrees() + random.nextDouble() * (joint.maxDegrees() - joint.minDegrees());
        }
        return Posture.of(degrees);
    }
}
