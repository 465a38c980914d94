package org.robonewbie.simulator.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Rotation;

class RotationMatrixTest {

    /** Turns x to y, y to z, z to x: a third of a full turn about (1, 1, 1). */
    private static final RotationMatrix CYCLE = new RotationMatrix(0, 0, 1, 1, 0, 0, 0, 1, 0);

    @Test
    void quarterTurnAboutZTurnsXToY() {
        Vector3 turned = RotationMatrix.aboutZ(Math.PI / 2).apply(new Vector3(1, 0, 0));

        assertThat(turned.distanceTo(new Vector3(0, 1, 0))).isLessThan(1e-15);
    }

    @Test
    void afterDoesTheArgumentFirst() {
        RotationMatrix both = RotationMatrix.aboutZ(Math.PI / 2).after(CYCLE);

        Vector3 turned = both.apply(new Vector3(0, 0, 1));

        assertThat(turned.distanceTo(new Vector3(0, 1, 0))).isLessThan(1e-15);
    }

    @Test
    void inverseTurnsBack() {
        Vector3 vector = new Vector3(1, 2, 3);

        assertThat(CYCLE.inverse().apply(CYCLE.apply(vector))).isEqualTo(vector);
    }

    @Test
    void quaternionOfAThirdOfATurn() {
        assertQuaternion(CYCLE.toQuaternion(), 0.5, 0.5, 0.5, 0.5);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 30, 89, 91, 150, 179, 180, -45, -120, -179})
    void quaternionAboutZHoldsHalfTheAngle(double degrees) {
        Rotation q = RotationMatrix.aboutZ(Math.toRadians(degrees)).toQuaternion();

        double half = Math.toRadians(degrees) / 2;
        assertQuaternion(q, Math.cos(half), 0, 0, Math.sin(half));
    }

    @Test
    void quaternionsOfHalfTurnsKeepTheirSigns() {
        RotationMatrix aboutDiagonal = new RotationMatrix(0, -1, 0, -1, 0, 0, 0, 0, -1);

        double root = Math.sqrt(0.5);

        Rotation q = aboutDiagonal.toQuaternion();
        assertThat(q.apply(new Vector3(1, 0, 0)).distanceTo(new Vector3(0, -1, 0)))
                .isLessThan(1e-12);
        assertThat(Math.abs(q.x())).isCloseTo(root, within(1e-12));
    }

    private static void assertQuaternion(Rotation q, double w, double x, double y, double z) {
        assertThat(new double[] {q.w(), q.x(), q.y(), q.z()}).containsExactly(new double[] {w, x, y, z}, within(1e-12));
    }
}
