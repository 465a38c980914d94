package org.robonewbie.nao.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;

class PostureTest {

    @Test
    void changesOneJointOnly() {
        Posture posture = Posture.ZERO.with(Joint.LEFT_KNEE_PITCH, -60);

        assertThat(posture.degrees(Joint.LEFT_KNEE_PITCH)).isEqualTo(-60);
        assertThat(posture.with(Joint.LEFT_KNEE_PITCH, 0)).isEqualTo(Posture.ZERO);
    }

    @Test
    void cannotBeChangedFromOutside() {
        double[] degrees = new double[Joint.COUNT];
        Posture posture = Posture.of(degrees);

        degrees[0] = 1;
        posture.toArray()[1] = 1;

        assertThat(posture).isEqualTo(Posture.ZERO).hasSameHashCodeAs(Posture.ZERO);
    }

    @Test
    void knowsNoNegativeZero() {
        assertThat(Posture.ZERO.with(Joint.NECK_YAW, -0.0)).isEqualTo(Posture.ZERO);
    }

    @Test
    void refusesAWrongNumberOfAngles() {
        assertThatThrownBy(() -> Posture.of(1, 2, 3))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Expected 22 angles, one for each joint, but got 3.");
    }

    @Test
    void refusesAnglesThatAreNoNumbers() {
        assertThatThrownBy(() -> Posture.ZERO.with(Joint.NECK_YAW, Double.NaN))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Angle NaN for NECK_YAW is not a finite number. Was something divided by zero?");
        double[] degrees = new double[Joint.COUNT];
        degrees[1] = Double.NEGATIVE_INFINITY;
        assertThatThrownBy(() -> Posture.of(degrees))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("Angle -Infinity for NECK_PITCH");
    }

    @Test
    void isForcedIntoTheRangesOfTheJoints() {
        Posture posture = Posture.ZERO.with(Joint.LEFT_KNEE_PITCH, 50).with(Joint.NECK_YAW, -500);

        assertThat(posture.clamped())
                .isEqualTo(Posture.ZERO.with(Joint.LEFT_KNEE_PITCH, 1).with(Joint.NECK_YAW, -120));
    }

    @Test
    void measuresTheLargestDifference() {
        Posture posture = Posture.ZERO.with(Joint.NECK_YAW, 10).with(Joint.LEFT_KNEE_PITCH, -30);

        assertThat(posture.largestDifference(Posture.ZERO)).isEqualTo(30);
        assertThat(posture.largestDifference(posture)).isZero();
    }
}
