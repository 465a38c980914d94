package org.robonewbie.nao.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

class ForwardKinematicsTest {

    private static final ForwardKinematics KINEMATICS = ForwardKinematics.of(RobotType.TYPE_0);

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void putsAllLinksWhereTheyWereConstructed(RobotType type) {
        NaoModel model = NaoModel.of(type);

        BodyPoses body = ForwardKinematics.of(type).poses(Posture.ZERO);

        for (int i = 0; i < model.links().size(); i++) {
            Vector3 expected = SimSparkFrame.toBody(model.links().get(i).position());
            assertNear(body.links().get(i).position(), expected);
            assertThat(body.links().get(i).rotation().angleDegrees()).isZero();
        }
    }

    /** Torso heights of standing robots as measured with rcssserver3d. */
    @ParameterizedTest
    @CsvSource({"TYPE_0, 0.385", "TYPE_1, 0.422", "TYPE_2, 0.385", "TYPE_3, 0.441", "TYPE_4, 0.385"})
    void standsAsHighAsTheRealOne(RobotType type, double height) {
        BodyPoses body = ForwardKinematics.of(type).poses(Posture.ZERO);

        for (Leg leg : Leg.values()) {
            assertThat(body.soleCorners(leg))
                    .allSatisfy(corner -> assertThat(corner.z()).isCloseTo(-height, within(0.0005)));
        }
    }

    /** A robot with arms stretched forward saw its forearms at (pol 0.19 ±34.99 -22.56) in rcssserver3d. */
    @Test
    void showsTheArmsWhereARealRobotSawThem() {
        BodyPoses body = KINEMATICS.poses(Posture.ZERO);

        Vector3 right = body.camera().inverse().transform(body.link("rlowerarm").position());
        Vector3 left = body.camera().inverse().transform(body.link("llowerarm").position());

        assertThat(right.length()).isCloseTo(0.19, within(0.005));
        assertThat(Math.toDegrees(Math.atan2(right.y(), right.x()))).isCloseTo(-34.99, within(0.005));
        assertThat(Math.toDegrees(Math.asin(right.z() / right.length()))).isCloseTo(-22.56, within(0.005));
        assertNear(left, new Vector3(right.x(), -right.y(), right.z()));
    }

    @ParameterizedTest
    @CsvSource({
        "NECK_YAW, head, 1, 0, 0, 0, 1, 0",
        "NECK_PITCH, head, 1, 0, 0, 0, 0, 1",
        "LEFT_SHOULDER_PITCH, llowerarm, 1, 0, 0, 0, 0, 1",
        "LEFT_SHOULDER_YAW, llowerarm, 1, 0, 0, 0, 1, 0",
        "LEFT_ARM_ROLL, llowerarm, 0, 0, 1, 0, -1, 0",
        "LEFT_ARM_YAW, llowerarm, 1, 0, 0, 0, 1, 0",
        "LEFT_HIP_ROLL, lfoot, 0, 0, -1, 0, 1, 0",
        "LEFT_HIP_PITCH, lfoot, 0, 0, -1, 1, 0, 0",
        "LEFT_KNEE_PITCH, lfoot, 0, 0, -1, 1, 0, 0",
        "LEFT_FOOT_PITCH, lfoot, 1, 0, 0, 0, 0, 1",
        "LEFT_FOOT_ROLL, lfoot, 0, 0, 1, 0, -1, 0"
    })
    void turnsLimbsAsTheJointsSay(
            Joint joint, String link, double x, double y, double z, double turnedX, double turnedY, double turnedZ) {
        BodyPoses body = KINEMATICS.poses(Posture.ZERO.with(joint, 90));

        Vector3 turned = body.link(link).rotation().apply(new Vector3(x, y, z));

        assertNear(turned, new Vector3(turnedX, turnedY, turnedZ));
    }

    @Test
    void hipYawPitchTurnsTheToesOutwardAndLiftsTheThigh() {
        BodyPoses body = KINEMATICS.poses(
                Posture.ZERO.with(Joint.LEFT_HIP_YAW_PITCH, -30).with(Joint.RIGHT_HIP_YAW_PITCH, -30));

        assertThat(body.foot(Leg.LEFT).rotation().yawDegrees()).isPositive();
        assertThat(body.foot(Leg.RIGHT).rotation().yawDegrees()).isNegative();
        assertThat(body.foot(Leg.LEFT).position().x()).isPositive();
        assertThat(body.foot(Leg.RIGHT).position().x()).isPositive();
    }

    @Test
    void calculatesTheCameraAlone() {
        Random random = new Random(1);
        for (int i = 0; i < 100; i++) {
            double yaw = random.nextDouble(-120, 120);
            double pitch = random.nextDouble(-45, 45);
            Posture posture = Posture.ZERO.with(Joint.NECK_YAW, yaw).with(Joint.NECK_PITCH, pitch);

            Pose camera = KINEMATICS.camera(yaw, pitch);

            assertThat(camera).isEqualTo(KINEMATICS.poses(posture).camera());
        }
    }

    @Test
    void findsTheCentreOfMass() {
        BodyPoses straight = KINEMATICS.poses(Posture.ZERO);
        BodyPoses armsDown = KINEMATICS.poses(
                Posture.ZERO.with(Joint.LEFT_SHOULDER_PITCH, -90).with(Joint.RIGHT_SHOULDER_PITCH, -90));

        assertThat(straight.centreOfMass().y()).isCloseTo(0, within(1e-12));
        assertThat(armsDown.centreOfMass().x())
                .isLessThan(straight.centreOfMass().x());
        assertThat(armsDown.centreOfMass().z())
                .isLessThan(straight.centreOfMass().z());
    }

    /** The centre of mass of two points is between them, in the ratio of their masses: checked with one leg moved. */
    @Test
    void weighsEachLink() {
        BodyPoses before = KINEMATICS.poses(Posture.ZERO);
        BodyPoses after = KINEMATICS.poses(Posture.ZERO.with(Joint.NECK_PITCH, 40));

        Vector3 headMoved =
                after.link("head").position().minus(before.link("head").position());
        Vector3 centreMoved = after.centreOfMass().minus(before.centreOfMass());

        assertNear(centreMoved, headMoved.times(0.35 / 4.6071));
    }

    @Test
    void findsTheCornersOfASole() {
        BodyPoses body = KINEMATICS.poses(Posture.ZERO);

        assertNear(body.soleCorners(Leg.LEFT).get(0), new Vector3(0.105, 0.095, -0.385));
        assertNear(body.soleCorners(Leg.LEFT).get(1), new Vector3(0.105, 0.015, -0.385));
        assertNear(body.soleCorners(Leg.LEFT).get(2), new Vector3(-0.055, 0.015, -0.385));
        assertNear(body.soleCorners(Leg.LEFT).get(3), new Vector3(-0.055, 0.095, -0.385));
    }

    private static void assertNear(Vector3 actual, Vector3 expected) {
        assertThat(actual.distanceTo(expected))
                .as("%s near %s", actual, expected)
                .isCloseTo(0, within(1e-9));
    }
}
