package org.robonewbie.nao.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;

class MirrorTest {

    @ParameterizedTest
    @CsvSource({
        "NECK_YAW, NECK_YAW, -10",
        "NECK_PITCH, NECK_PITCH, 10",
        "LEFT_SHOULDER_PITCH, RIGHT_SHOULDER_PITCH, 10",
        "LEFT_SHOULDER_YAW, RIGHT_SHOULDER_YAW, -10",
        "LEFT_ARM_ROLL, RIGHT_ARM_ROLL, -10",
        "LEFT_ARM_YAW, RIGHT_ARM_YAW, -10",
        "LEFT_HIP_YAW_PITCH, RIGHT_HIP_YAW_PITCH, 10",
        "LEFT_HIP_ROLL, RIGHT_HIP_ROLL, -10",
        "RIGHT_HIP_PITCH, LEFT_HIP_PITCH, 10",
        "RIGHT_KNEE_PITCH, LEFT_KNEE_PITCH, 10",
        "RIGHT_FOOT_PITCH, LEFT_FOOT_PITCH, 10",
        "RIGHT_FOOT_ROLL, LEFT_FOOT_ROLL, -10"
    })
    void exchangesTheSides(Joint joint, Joint partner, double degrees) {
        assertThat(Mirror.partner(joint)).isEqualTo(partner);
        assertThat(Mirror.partner(partner)).isEqualTo(joint);
        assertThat(Mirror.mirroredDegrees(joint, 10)).isEqualTo(degrees);
    }

    @ParameterizedTest
    @EnumSource(Joint.class)
    void keepsTheRangesOfTheJoints(Joint joint) {
        Joint partner = Mirror.partner(joint);

        double one = Mirror.mirroredDegrees(joint, joint.minDegrees());
        double other = Mirror.mirroredDegrees(joint, joint.maxDegrees());

        assertThat(Math.min(one, other)).isEqualTo(partner.minDegrees());
        assertThat(Math.max(one, other)).isEqualTo(partner.maxDegrees());
    }

    @Test
    void bringsEachLimbWhereTheMirrorShowsIt() {
        Random random = new Random(1);
        NaoModel model = NaoModel.of(RobotType.TYPE_0);
        for (int i = 0; i < 200; i++) {
            Posture posture = randomPosture(random);

            BodyPoses body = ForwardKinematics.of(RobotType.TYPE_0).poses(posture);
            BodyPoses mirrored = ForwardKinematics.of(RobotType.TYPE_0).poses(posture.mirrored());

            for (Link link : model.links()) {
                Vector3 corner = new Vector3(0.01, 0.02, 0.03);
                Vector3 expected = mirror(body.link(link.name()).transform(corner));
                Vector3 actual = mirrored.link(partnerName(link.name())).transform(mirror(corner));
                assertThat(actual.distanceTo(expected)).as(link.name()).isCloseTo(0, within(1e-12));
            }
        }
    }

    @Test
    void makesNoNegativeZeros() {
        assertThat(Posture.ZERO.mirrored()).isEqualTo(Posture.ZERO);
    }

    private static Vector3 mirror(Vector3 vector) {
        return new Vector3(vector.x(), -vector.y(), vector.z());
    }

    private static String partnerName(String link) {
        if (link.startsWith("l")) {
            return "r" + link.substring(1);
        }
        return link.startsWith("r") ? "l" + link.substring(1) : link;
    }

    private static Posture randomPosture(Random random) {
        double[] degrees = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] = random.nextDouble(joint.minDegrees(), joint.maxDegrees());
        }
        return Posture.of(degrees);
    }
}
