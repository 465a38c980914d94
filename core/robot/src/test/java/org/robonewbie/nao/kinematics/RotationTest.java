package org.robonewbie.nao.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;

class RotationTest {

    private static final Vector3 FORWARD = new Vector3(1, 0, 0);
    private static final Vector3 LEFT = new Vector3(0, 1, 0);
    private static final Vector3 UP = new Vector3(0, 0, 1);

    @Test
    void turnsByTheRightHandRule() {
        assertNear(Rotation.about(UP, 90).apply(FORWARD), LEFT);
        assertNear(Rotation.about(LEFT, 90).apply(UP), FORWARD);
        assertNear(Rotation.about(FORWARD.times(5), 90).apply(LEFT), UP);
        assertNear(Rotation.NONE.apply(new Vector3(1, 2, 3)), new Vector3(1, 2, 3));
    }

    @Test
    void yawsLeftBowsDownAndLeansRight() {
        assertNear(Rotation.ofYawPitchRoll(90, 0, 0).apply(FORWARD), LEFT);
        assertNear(Rotation.ofYawPitchRoll(0, 90, 0).apply(FORWARD), UP.times(-1));
        assertNear(Rotation.ofYawPitchRoll(0, 0, 90).apply(UP), LEFT.times(-1));
        assertNear(Rotation.ofYawPitchRoll(90, 90, 0).apply(UP), LEFT);
    }

    @Test
    void joinsTurnsAndTurnsBack() {
        Rotation first = Rotation.about(new Vector3(1, 2, 3), 40);
        Rotation second = Rotation.about(new Vector3(-1, 0.5, 0), -70);
        Vector3 vector = new Vector3(0.3, -0.2, 0.9);

        assertNear(second.times(first).apply(vector), second.apply(first.apply(vector)));
        assertNear(first.inverse().apply(first.apply(vector)), vector);
    }

    @Test
    void measuresItsAngle() {
        assertThat(Rotation.about(new Vector3(1, 1, 0), -35).angleDegrees()).isCloseTo(35, within(1e-12));
        assertThat(Rotation.about(UP, 350).angleDegrees()).isCloseTo(10, within(1e-12));
        assertThat(Rotation.NONE.angleDegrees()).isZero();
    }

    @Test
    void tellsItsHeading() {
        assertThat(Rotation.ofYawPitchRoll(-130, 20, 10).yawDegrees()).isCloseTo(-130, within(1e-12));
    }

    @Test
    void posesAreChained() {
        Pose body = new Pose(new Vector3(1, 0, 0), Rotation.about(UP, 90));
        Pose head = new Pose(new Vector3(0.5, 0, 1), Rotation.about(UP, -30));

        Pose headInWorld = body.times(head);

        assertNear(headInWorld.position(), new Vector3(1, 0.5, 1));
        assertThat(headInWorld.rotation().yawDegrees()).isCloseTo(60, within(1e-12));
        assertNear(body.inverse().times(headInWorld).position(), head.position());
        assertNear(Pose.ORIGIN.times(body).position(), body.position());
    }

    @Test
    void convertsToSimSparkAndBack() {
        Vector3 vector = new Vector3(0.1, 0.2, 0.3);
        Pose pose = new Pose(vector, Rotation.ofYawPitchRoll(20, 30, 40));
        Vector3 point = new Vector3(-0.5, 0.7, 0.9);

        assertThat(SimSparkFrame.fromBody(FORWARD)).isEqualTo(new Vector3(0, 1, 0));
        assertThat(SimSparkFrame.fromBody(LEFT)).isEqualTo(new Vector3(-1, 0, 0));
        assertThat(SimSparkFrame.toBody(SimSparkFrame.fromBody(vector))).isEqualTo(vector);
        assertThat(SimSparkFrame.toBody(SimSparkFrame.fromBody(pose))).isEqualTo(pose);
        assertNear(
                SimSparkFrame.fromBody(pose).transform(SimSparkFrame.fromBody(point)),
                SimSparkFrame.fromBody(pose.transform(point)));
    }

    private static void assertNear(Vector3 actual, Vector3 expected) {
        assertThat(actual.distanceTo(expected))
                .as("%s near %s", actual, expected)
                .isCloseTo(0, within(1e-12));
    }
}
