package org.robonewbie.learning.gait;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.Gait;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

class FootstepsTest {

    private static final Gait GAIT = Gait.of(320, 8, new double[Gait.PARAMETERS]);

    @Test
    void givesEachStepItsTimeAndKeyframes() {
        List<Keyframe> keyframes = new Footsteps(GAIT, Stance.LEFT_FOOT, Stance.RIGHT_FOOT)
                .step(Leg.LEFT, Stance.LEFT_FOOT.then(0.04, 0, 0))
                .step(Leg.RIGHT, Stance.RIGHT_FOOT.then(0.04, 0, 0))
                .keyframes();

        assertThat(keyframes).hasSize(16);
        assertThat(new Motion("two steps", keyframes).durationMillis()).isEqualTo(640);
    }

    @Test
    void stepsWithTheOtherFootAreTheMirrorImage() {
        List<Keyframe> left =
                walking(-0.03).step(Leg.LEFT, Stance.LEFT_FOOT.then(0.09, 0, 0)).keyframes();
        List<Keyframe> right = walking(0.03)
                .step(Leg.RIGHT, Stance.RIGHT_FOOT.then(0.09, 0, 0))
                .keyframes();

        for (int i = 0; i < left.size(); i++) {
            Posture mirrored = right.get(i).posture().mirrored();
            assertThat(left.get(i).posture().largestDifference(mirrored)).isLessThan(0.05);
        }
    }

    @Test
    void setsTheFootDownWhereItShallStand() {
        List<Keyframe> keyframes = new Footsteps(GAIT, Stance.LEFT_FOOT, Stance.RIGHT_FOOT)
                .step(Leg.LEFT, Stance.LEFT_FOOT.then(0.05, 0, 0))
                .keyframes();

        Posture end = keyframes.get(keyframes.size() - 1).posture();
        Vector3 between = foot(end, "lfoot").minus(foot(end, "rfoot"));
        double lean = Math.toRadians(GAIT.leanDegrees());
        assertThat(between.x() * Math.cos(lean) + between.z() * Math.sin(lean)).isCloseTo(0.05, within(1e-3));
        assertThat(between.y()).isCloseTo(0.11, within(1e-3));
    }

    @Test
    void keepsWithinTheJointsRanges() {
        List<Keyframe> keyframes = new Footsteps(GAIT, Stance.LEFT_FOOT, Stance.RIGHT_FOOT)
                .step(Leg.LEFT, Stance.LEFT_FOOT.then(0.3, 0, 0))
                .keyframes();

        assertThat(keyframes)
                .allSatisfy(keyframe -> assertThat(keyframe.posture())
                        .isEqualTo(keyframe.posture().clamped()));
    }

    @Test
    void swingsTheArmAgainstTheLeg() {
        List<Keyframe> keyframes = new Footsteps(GAIT, Stance.LEFT_FOOT, Stance.RIGHT_FOOT)
                .step(Leg.LEFT, Stance.LEFT_FOOT.then(0.05, 0, 0))
                .keyframes();

        Posture end = keyframes.get(keyframes.size() - 1).posture();
        assertThat(end.degrees(Joint.RIGHT_SHOULDER_PITCH)).isGreaterThan(end.degrees(Joint.LEFT_SHOULDER_PITCH) + 20);
    }

    private static Footsteps walking(double leftAhead) {
        return new Footsteps(GAIT, Stance.LEFT_FOOT.then(leftAhead, 0, 0), Stance.RIGHT_FOOT.then(-leftAhead, 0, 0));
    }

    private static Vector3 foot(Posture posture, String link) {
        return ForwardKinematics.of(RobotType.TYPE_0).poses(posture).link(link).position();
    }
}
