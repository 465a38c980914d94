package org.robonewbie.agent.perception;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;

class CameraTransformationTest {

    private static final double TINY = 1e-9;

    @Test
    void addsTheAnglesOfNeckAndCamera() {
        Direction seen = new Direction(2, 10, -5);

        Direction forward = CameraTransformation.SUM_OF_ANGLES.toFacingForward(seen, 30, -20);

        assertThat(forward).isEqualTo(new Direction(2, 40, -25));
    }

    @Test
    void isExactForTheSimpleSumWhileTheHeadIsLevel() {
        Direction seen = new Direction(2, 10, -5);

        Direction exact = CameraTransformation.KINEMATICS.toFacingForward(seen, 30, 0);

        assertThat(exact.bearing()).isCloseTo(40, within(TINY));
        assertThat(exact.elevation()).isCloseTo(-5, within(TINY));
    }

    @Test
    void looksDownWithNegativePitch() {
        Direction exact = CameraTransformation.KINEMATICS.toFacingForward(new Direction(2, 0, 0), 0, -40);

        assertThat(exact.elevation()).isCloseTo(-40, within(0.2));
    }

    @Test
    void knowsThatTheHeadTiltsAboutAPointBelowItsCentre() {
        Direction exact = CameraTransformation.KINEMATICS.toFacingForward(new Direction(2, 0, 0), 0, 45);

        double sine = Math.sqrt(0.5);
        Vector3 expected = new Vector3(2 * sine - 0.005 * sine, 0, 2 * sine - 0.005 * (1 - sine));
        assertThat(exact.toPoint().distanceTo(expected)).isLessThan(TINY);
    }

    @Test
    void differsFromTheSimpleSumByHalfAMetreFarAsideAndDown() {
        Direction seen = new Direction(2, 45, 0);

        Direction simple = CameraTransformation.SUM_OF_ANGLES.toFacingForward(seen, 0, -40);
        Direction exact = CameraTransformation.KINEMATICS.toFacingForward(seen, 0, -40);

        assertThat(simple.toPoint().distanceTo(exact.toPoint())).isCloseTo(0.50, within(0.01));
    }

    @Test
    void keepsBearingsBetweenMinusAndPlus180Degrees() {
        Direction forward = CameraTransformation.SUM_OF_ANGLES.toFacingForward(new Direction(2, 80, 0), 120, 0);

        assertThat(forward.bearing()).isEqualTo(-160);
    }
}
