package org.robonewbie.workshop.fidelity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.RotationMatrix;

class TorsoAnglesTest {

    @Test
    void yawTurnsTheForwardAxisFromXToY() {
        RotationMatrix rotation = TorsoAngles.rotation(90, 0, 0, 1);

        assertThat(rotation.axisY().distanceTo(new Vector3(0, 1, 0))).isLessThan(1e-12);
        assertThat(rotation.axisX().distanceTo(new Vector3(1, 0, 0))).isLessThan(1e-12);
        assertThat(TorsoAngles.yawDegrees(rotation)).isCloseTo(90, within(1e-9));
    }

    @Test
    void pitchLiftsTheForwardAxis() {
        RotationMatrix rotation = TorsoAngles.rotation(0, 30, 0, Math.cos(Math.toRadians(30)));

        assertThat(rotation.axisY().z()).isCloseTo(0.5, within(1e-12));
        assertThat(rotation.axisZ().x()).isCloseTo(-0.5, within(1e-12));
    }

    @Test
    void rollLiftsTheRightAxis() {
        RotationMatrix rotation = TorsoAngles.rotation(0, 0, 30, Math.cos(Math.toRadians(30)));

        assertThat(rotation.axisX().z()).isCloseTo(0.5, within(1e-12));
    }

    @Test
    void negativeUpMeansOnTheHead() {
        RotationMatrix rotation = TorsoAngles.rotation(0, 0, 0, -1);

        assertThat(rotation.axisZ().z()).isCloseTo(-1, within(1e-12));
        assertThat(rotation.axisX().y()).isCloseTo(1, within(1e-12));
    }

    @Test
    void degreesBetweenIsTheAngleOfTheTurnFromOneToTheOther() {
        RotationMatrix one = TorsoAngles.rotation(10, 0, 0, 1);
        RotationMatrix two = TorsoAngles.rotation(13, 0, 0, 1);

        assertThat(TorsoAngles.degreesBetween(one, two)).isCloseTo(3, within(1e-9));
        assertThat(TorsoAngles.degreesBetween(one, one)).isCloseTo(0, within(1e-9));
    }
}
