package org.robonewbie.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.nao.T1Joint;
import org.robonewbie.nao.kinematics.Pose;

/** The league's robots. Expected values were read from a running rcsssmj 0.2.1 and from MuJoCo 3.5.0. */
class BoosterRobotsTest {

    static Stream<RobotModel> robots() {
        return Stream.of(BoosterT1.MODEL, BoosterK1.MODEL);
    }

    static Stream<Arguments> masses() {
        return Stream.of(Arguments.of(BoosterT1.MODEL, 24, 31.614357), Arguments.of(BoosterK1.MODEL, 23, 19.666));
    }

    @ParameterizedTest
    @MethodSource("masses")
    void massIsThatOfTheServersModel(RobotModel robot, int bodies, double massKg) {
        assertThat(robot.bodies()).hasSize(bodies);
        assertThat(robot.massKg()).isEqualTo(massKg, within(1e-9));
    }

    @Test
    void jointsOfTheT1HaveTheNamesAndRangesOfItsModel() {
        for (T1Joint joint : T1Joint.values()) {
            RobotJoint modelled = BoosterT1.MODEL.joints().get(joint.ordinal());
            String name = modelled.name().replaceFirst("^AAHead|^Head", "NECK").toUpperCase(Locale.ROOT);
            assertThat(joint.name()).isEqualTo(name);
            assertThat(joint.minDegrees()).isCloseTo(modelled.minDegrees(), within(0.051));
            assertThat(joint.maxDegrees()).isCloseTo(modelled.maxDegrees(), within(0.051));
        }
        assertThat(T1Joint.values()).hasSameSizeAs(BoosterT1.MODEL.joints());
    }

    @Test
    void jointsOfT1AreThoseOfTheServersFirstMessageInItsOrder() {
        assertThat(BoosterT1.MODEL.joints())
                .extracting(RobotJoint::perceptorName)
                .containsExactly(
                        ("q_hj1 q_hj2 q_laj1 q_laj2 q_laj3 q_laj4 q_raj1 q_raj2 q_raj3 q_raj4 q_tj1 q_llj1 q_llj2 q_llj3"
                                        + " q_llj4 q_llj5 q_llj6 q_rlj1 q_rlj2 q_rlj3 q_rlj4 q_rlj5 q_rlj6")
                                .split(" "));
    }

    @Test
    void jointsOfK1AreThoseOfTheServersFirstMessageInItsOrder() {
        assertThat(BoosterK1.MODEL.joints())
                .extracting(RobotJoint::perceptorName)
                .containsExactly(("q_hj1 q_hj2 q_laj1 q_laj2 q_laj3 q_laj4 q_raj1 q_raj2 q_raj3 q_raj4 q_llj1 q_llj2"
                                + " q_llj3 q_llj4 q_llj5 q_llj6 q_rlj1 q_rlj2 q_rlj3 q_rlj4 q_rlj5 q_rlj6")
                        .split(" "));
    }

    @ParameterizedTest
    @MethodSource("robots")
    void kneesBendWithPositiveAngles(RobotModel robot) {
        RobotJoint knee = robot.joint("lle4").orElseThrow();
        double[] degrees = new double[robot.joints().size()];
        List<Pose> straight = robot.bodyPoses(degrees);
        degrees[knee.index()] = 90;

        List<Pose> bent = robot.bodyPoses(degrees);

        int foot = robot.bodyIndex("left_foot_link");
        assertThat(bent.get(foot).position().x())
                .isLessThan(straight.get(foot).position().x() - 0.2);
        assertThat(knee.minDegrees()).isZero();
    }

    @ParameterizedTest
    @MethodSource("robots")
    void solesTouchTheGroundInTheStance(RobotModel robot) {
        List<Pose> poses = robot.bodyPoses(robot.stanceDegrees());

        for (String side : List.of("left_foot_link", "right_foot_link")) {
            int foot = robot.bodyIndex(side);
            PlacedShape sole = robot.bodies().get(foot).shapes().get(0);
            double bottom = poses.get(foot).times(sole.pose()).position().z()
                    - sole.shape().size().z() / 2;
            assertThat(robot.stanceHeight() + bottom).isEqualTo(0, within(0.001));
            assertThat(poses.get(foot).rotation().angleDegrees()).isEqualTo(0, within(1e-6));
        }
    }

    @ParameterizedTest
    @MethodSource("robots")
    void stanceIsWithinTheRanges(RobotModel robot) {
        for (RobotJoint joint : robot.joints()) {
            assertThat(joint.clampDegrees(joint.stanceDegrees()))
                    .as(joint.name())
                    .isEqualTo(joint.stanceDegrees());
        }
    }

    @Test
    void parentOfABodyStandsBeforeIt() {
        RobotBody torso = BoosterT1.MODEL.bodies().get(0);
        RobotBody head = BoosterT1.MODEL.bodies().get(1);

        assertThatThrownBy(() -> new RobotModel("mixed", List.of(head, torso), List.of(), 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Body \"H1\" of robot mixed has the parent 0. The torso comes first, and each parent before"
                        + " its children.");
    }

    @Test
    void unknownBodyIsNamed() {
        assertThatThrownBy(() -> BoosterK1.MODEL.bodyIndex("tail"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Robot K1 has no body \"tail\".");
    }
}
