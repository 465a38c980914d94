package org.robonewbie.simulator.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.Vector3;

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
        assertThat(CYCLE.applyInverse(CYCLE.apply(vector))).isEqualTo(vector);
    }

    @Test
    void quaternionOfAThirdOfATurn() {
        assertThat(CYCLE.toQuaternion()).containsExactly(new double[] {0.5, 0.5, 0.5, 0.5}, within(1e-15));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 30, 89, 91, 150, 179, 180, -45, -120, -179})
    void quaternionAboutZHoldsHalfTheAngle(double degrees) {
        double[] q = RotationMatrix.aboutZ(Math.toRadians(degrees)).toQuaternion();

        double half = Math.toRadians(degrees) / 2;
        assertThat(q).containsExactly(new double[] {Math.cos(half), 0, 0, Math.sin(half)}, within(1e-12));
    }

    @Test
    void quaternionsOfHalfTurnsKeepTheirSigns() {
        RotationMatrix aboutDiagonal = new RotationMatrix(0, -1, 0, -1, 0, 0, 0, 0, -1);

        double root = Math.sqrt(0.5);

        assertThat(rotationOf(aboutDiagonal.toQuaternion())
                        .minus(new Vector3(0, -1, 0))
                        .length())
                .isLessThan(1e-12);
        assertThat(Math.abs(aboutDiagonal.toQuaternion()[1])).isCloseTo(root, within(1e-12));
    }

    /** Where a quaternion turns the x axis. */
    private static Vector3 rotationOf(double[] q) {
        return new Vector3(
                1 - 2 * (q[2] * q[2] + q[3] * q[3]), 2 * (q[1] * q[2] + q[0] * q[3]), 2 * (q[1] * q[3] - q[0] * q[2]));
    }
}
