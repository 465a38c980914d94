package org.robonewbie.nao.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

class InverseKinematicsTest {

    private static final long SEED = 1;
    private static final ForwardKinematics FORWARD = ForwardKinematics.of(RobotType.TYPE_0);

    private final InverseKinematics inverse = new InverseKinematics(RobotType.TYPE_0);

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void findsAnglesForEveryFootPoseThatALegCanTake(RobotType type) {
        ForwardKinematics forward = ForwardKinematics.of(type);
        InverseKinematics inverseOfType = new InverseKinematics(type);
        Random random = new Random(SEED);
        for (int i = 0; i < 1000; i++) {
            Leg leg = i % 2 == 0 ? Leg.LEFT : Leg.RIGHT;
            Posture posture = randomPosture(random);
            Pose wanted = forward.poses(posture).foot(leg);

            LegSolution solution = inverseOfType.solve(leg, wanted);

            assertThat(solution.isReachable()).as("%s leg of %s", leg, posture).isTrue();
            Posture reachedPosture = solution.applyTo(posture);
            assertThat(reachedPosture).isEqualTo(reachedPosture.clamped());
            assertReached(forward.poses(reachedPosture).foot(leg), wanted);
        }
    }

    @Test
    void standsStraight() {
        Pose wanted = FORWARD.poses(Posture.ZERO).foot(Leg.LEFT);

        LegSolution solution = inverse.solve(Leg.LEFT, wanted);

        assertThat(solution.isReachable()).isTrue();
        assertReached(FORWARD.poses(solution.applyTo(Posture.ZERO)).foot(Leg.LEFT), wanted);
    }

    @Test
    void bendsTheKneesToComeDown() {
        Pose wanted = new Pose(new Vector3(0.02, 0.055, -0.33), Rotation.NONE);

        LegSolution solution = inverse.solve(Leg.LEFT, wanted);

        assertThat(solution.isReachable()).isTrue();
        assertThat(solution.degrees(Joint.LEFT_KNEE_PITCH)).isBetween(-80.0, -30.0);
        double sum = solution.degrees(Joint.LEFT_HIP_PITCH)
                + solution.degrees(Joint.LEFT_KNEE_PITCH)
                + solution.degrees(Joint.LEFT_FOOT_PITCH);
        assertThat(sum).isCloseTo(0, within(0.01));
        assertThat(solution.degrees(Joint.LEFT_HIP_ROLL)).isCloseTo(0, within(0.01));
    }

    @Test
    void turnsTheFootOutward() {
        Pose wanted = new Pose(new Vector3(0.03, 0.055, -0.32), Rotation.ofYawPitchRoll(15, 0, 0));

        LegSolution solution = inverse.solve(Leg.LEFT, wanted);

        assertThat(solution.isReachable()).isTrue();
        assertThat(solution.degrees(Joint.LEFT_HIP_YAW_PITCH)).isLessThan(-10);
        assertReached(FORWARD.poses(solution.applyTo(Posture.ZERO)).foot(Leg.LEFT), wanted);
    }

    @Test
    void findsMirroredAnglesForTheOtherLeg() {
        Random random = new Random(SEED);
        for (int i = 0; i < 200; i++) {
            Vector3 position = new Vector3(
                    random.nextDouble(-0.03, 0.06), random.nextDouble(0.05, 0.09), random.nextDouble(-0.34, -0.28));
            double yaw = random.nextDouble(5, 20);
            Pose left = new Pose(position, Rotation.ofYawPitchRoll(yaw, 5, 3));
            Vector3 mirrored = new Vector3(position.x(), -position.y(), position.z());
            Pose right = new Pose(mirrored, Rotation.ofYawPitchRoll(-yaw, 5, -3));

            Posture one = inverse.solve(Leg.LEFT, left).applyTo(Posture.ZERO);
            Posture other = inverse.solve(Leg.RIGHT, right).applyTo(Posture.ZERO);

            assertThat(inverse.solve(Leg.LEFT, left).isReachable()).isTrue();
            assertThat(other.largestDifference(one.mirrored())).isLessThan(1e-5);
        }
    }

    @Test
    void followsAPathWithoutJumps() {
        Posture posture = inverse.solve(Leg.LEFT, onPath(0)).applyTo(Posture.ZERO);
        for (int i = 1; i <= 200; i++) {
            LegSolution solution = inverse.solve(Leg.LEFT, onPath(i / 200.0), posture);

            Posture next = solution.applyTo(posture);

            assertThat(solution.isReachable()).isTrue();
            assertThat(next.largestDifference(posture)).isLessThan(5);
            posture = next;
        }
    }

    @Test
    void saysWhenAPoseCannotBeReached() {
        Pose tooFar = new Pose(new Vector3(0, 0.055, -0.5), Rotation.NONE);

        LegSolution solution = inverse.solve(Leg.LEFT, tooFar);

        assertThat(solution.isReachable()).isFalse();
        assertThat(solution.positionErrorMetres()).isBetween(0.12, 0.13);
        Pose nearest = FORWARD.poses(solution.applyTo(Posture.ZERO)).foot(Leg.LEFT);
        assertThat(nearest.position().distanceTo(tooFar.position()))
                .isCloseTo(solution.positionErrorMetres(), within(1e-6));
        assertThat(solution.degrees(Joint.LEFT_KNEE_PITCH)).isCloseTo(0, within(1.5));
    }

    @Test
    void saysWhenAFootCannotBeTurnedSo() {
        Pose inward = new Pose(new Vector3(0, 0.055, -0.35), Rotation.ofYawPitchRoll(-60, 0, 0));

        LegSolution solution = inverse.solve(Leg.LEFT, inward);

        assertThat(solution.isReachable()).isFalse();
        assertThat(solution.rotationErrorDegrees()).isGreaterThan(10);
    }

    @Test
    void bearsAFootTurnedBackwards() {
        Pose backwards = new Pose(new Vector3(0, 0.055, -0.35), Rotation.ofYawPitchRoll(180, 0, 0));

        assertThat(inverse.solve(Leg.LEFT, backwards).isReachable()).isFalse();
    }

    @Test
    void knowsTheJointsOfItsLegOnly() {
        LegSolution solution = inverse.solve(Leg.LEFT, new Pose(new Vector3(0, 0.055, -0.35), Rotation.NONE));

        assertThatThrownBy(() -> solution.degrees(Joint.RIGHT_KNEE_PITCH))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("RIGHT_KNEE_PITCH is not a joint of the LEFT leg.");
    }

    @Test
    void leavesTheOtherLimbsAlone() {
        Posture posture = randomPosture(new Random(SEED));

        Posture changed = inverse.solve(Leg.RIGHT, new Pose(new Vector3(0, -0.055, -0.35), Rotation.NONE))
                .applyTo(posture);

        for (Joint joint : Joint.values()) {
            if (!Leg.RIGHT.joints().contains(joint)) {
                assertThat(changed.degrees(joint)).isEqualTo(posture.degrees(joint));
            }
        }
    }

    /** A step: forward, up and down, and the foot turned outward. */
    private static Pose onPath(double fraction) {
        Vector3 position =
                new Vector3(0.05 * Math.cos(Math.PI * fraction), 0.055, -0.34 + 0.04 * Math.sin(Math.PI * fraction));
        return new Pose(position, Rotation.ofYawPitchRoll(10 * fraction, 0, 0));
    }

    private static void assertReached(Pose reached, Pose wanted) {
        assertThat(reached.position().distanceTo(wanted.position())).isLessThan(1.01e-4);
        assertThat(reached.rotation().times(wanted.rotation().inverse()).angleDegrees())
                .isLessThan(0.051);
    }

    private static Posture randomPosture(Random random) {
        double[] degrees = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] = random.nextDouble(joint.minDegrees(), joint.maxDegrees());
        }
        return Posture.of(degrees);
    }
}
