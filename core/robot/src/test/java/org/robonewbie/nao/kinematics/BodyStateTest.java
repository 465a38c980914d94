package org.robonewbie.nao.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

class BodyStateTest {

    private static final double STANDING_HEIGHT = 0.385;

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "90, 0, 0", "-135, 20, 0", "30, 0, -70", "170, 120, 10"})
    void headingAndTiltAreThoseOfTheTorso(double yaw, double pitch, double roll) {
        BodyState body = standing(new Vector3(1, 2, STANDING_HEIGHT), Rotation.ofYawPitchRoll(yaw, pitch, roll));

        double up = Math.cos(Math.toRadians(pitch)) * Math.cos(Math.toRadians(roll));
        assertThat(body.tiltDegrees()).isCloseTo(Math.toDegrees(Math.acos(up)), within(1e-9));
        double heading = Math.abs(pitch) < 90 ? yaw : yaw - Math.copySign(180, yaw);
        assertThat(body.headingDegrees()).isCloseTo(heading, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0.385, false, true",
        "29, 0.26, false, true",
        "31, 0.385, false, false",
        "0, 0.24, false, false",
        "59, 0.21, false, false",
        "61, 0.385, true, false",
        "0, 0.19, true, false"
    })
    void fallenIsTiltedOrLow(double pitch, double height, boolean fallen, boolean onItsFeet) {
        BodyState body = standing(new Vector3(0, 0, height), Rotation.ofYawPitchRoll(40, pitch, 0));

        assertThat(body.isFallen()).isEqualTo(fallen);
        assertThat(body.isStanding()).isEqualTo(onItsFeet);
    }

    @Test
    void limbsTurnAndMoveWithTheTorso() {
        BodyState body = standing(new Vector3(3, -1, 0.5), Rotation.ofYawPitchRoll(90, 0, 0));

        Vector3 camera = body.limbs().camera().position();
        Vector3 fromTorso = ForwardKinematics.of(RobotType.TYPE_0).camera(0, 0).position();

        assertThat(camera.x()).isCloseTo(3 - fromTorso.y(), within(1e-12));
        assertThat(camera.y()).isCloseTo(-1 + fromTorso.x(), within(1e-12));
        assertThat(camera.z()).isCloseTo(0.5 + fromTorso.z(), within(1e-12));
        assertThat(body.limbs().centreOfMass().x()).isCloseTo(3, within(0.01));
    }

    @Test
    void bothSolesCarryARobotThatStands() {
        BodyState body = standing(new Vector3(1, 0, STANDING_HEIGHT), Rotation.NONE);

        List<Vector3> support = body.limbs().supportPolygon();

        assertThat(support)
                .containsExactlyInAnyOrder(
                        new Vector3(1.105, 0.095, 0),
                        new Vector3(0.945, 0.095, 0),
                        new Vector3(0.945, -0.095, 0),
                        new Vector3(1.105, -0.095, 0));
    }

    @Test
    void nothingCarriesARobotInTheAir() {
        assertThat(standing(new Vector3(0, 0, 1), Rotation.NONE).limbs().supportPolygon())
                .isEmpty();
    }

    @Test
    void toesBendWithTheirHinges() {
        NaoModel model = NaoModel.of(RobotType.TYPE_4);
        double[] degrees = new double[model.hinges().size()];
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = model.hinges().get(i).perceptorName().endsWith("j7") ? 30 : 0;
        }

        BodyState bent = BodyState.ofHinges(RobotType.TYPE_4, Pose.ORIGIN, degrees);

        assertThat(bent.hingeDegrees()).isEqualTo(degrees);
        assertThat(bent.joints().toArray()).containsOnly(0);
        assertThat(bent.limbs().link("ltoe").rotation().angleDegrees()).isCloseTo(30, within(1e-9));
    }

    @Test
    void eachHingeHasItsAngle() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> BodyState.ofHinges(RobotType.TYPE_4, Pose.ORIGIN, new double[Joint.COUNT]))
                .withMessageContaining("24 angles, one for each hinge of robot TYPE_4, but got 22");
    }

    private static BodyState standing(Vector3 torso, Rotation turn) {
        return BodyState.of(RobotType.TYPE_0, new Pose(torso, turn), Posture.ZERO);
    }
}
