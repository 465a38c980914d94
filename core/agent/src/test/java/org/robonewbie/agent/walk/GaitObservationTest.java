package org.robonewbie.agent.walk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Posture;

class GaitObservationTest {

    private final GaitObservation observation = new GaitObservation();
    private double[] action = new double[12];

    @Test
    void robotThatStandsStillObservesGravityAndTheClockOnly() {
        see(Stance.POSTURE, TorsoMotion.AT_REST, FootPressure.NONE);

        assertThat(observation.values(action)).hasSameSizeAs(GaitObservation.INPUTS.toArray());
        assertThat(value("accelerometer.up", "10 m/s²")).isCloseTo(0.98, within(0.01));
        assertThat(Arrays.stream(observation.values(action))
                        .filter(value -> value != 0)
                        .count())
                .isEqualTo(3);
    }

    @Test
    void clockTakesTwentyCycles() {
        for (int cycle = 1; cycle <= 25; cycle++) {
            see(Stance.POSTURE, TorsoMotion.AT_REST, FootPressure.NONE);
            if (cycle % 20 == 5) {
                assertThat(value("gait.sine", "1")).isCloseTo(1, within(1e-9));
                assertThat(value("gait.cosine", "1")).isCloseTo(0, within(1e-9));
            }
        }
    }

    @Test
    void jointIsObservedByItsOffsetAndItsSpeed() {
        for (int cycle = 0; cycle < 4; cycle++) {
            Posture bent = Stance.POSTURE.with(Joint.LEFT_KNEE_PITCH, -70 - 3 * cycle);
            see(bent, TorsoMotion.AT_REST, FootPressure.NONE);
        }

        assertThat(value("offset.LEFT_KNEE_PITCH", "30 degrees")).isCloseTo(-9 / 30.0, within(1e-9));
        assertThat(value("speed.LEFT_KNEE_PITCH", "150 degrees/s")).isCloseTo(-1, within(1e-9));
        assertThat(value("speed.RIGHT_KNEE_PITCH", "150 degrees/s")).isZero();
    }

    @Test
    void torsoThatLeansForwardIsObservedByGyroscopeAndAccelerometer() {
        for (int cycle = 0; cycle < 50; cycle++) {
            see(Stance.POSTURE, TorsoMotion.AT_REST.withGyro(new Vector3(0, 10, 0)), FootPressure.NONE);
        }

        assertThat(value("gyro.left", "100 degrees/s")).isCloseTo(0.1, within(1e-9));
        assertThat(value("tilt.forward", "20 degrees")).isBetween(0.2, 0.5);
        assertThat(value("tilt.left", "20 degrees")).isZero();
    }

    @Test
    void solesAndTheLastActionAreObservedAndShocksAreClipped() {
        see(Stance.POSTURE, TorsoMotion.AT_REST, new FootPressure(new Vector3(0.05, 0.01, 0), new Vector3(0, 0, 1000)));
        action = new double[] {0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1};

        assertThat(value("leftFoot.point.forward", "0.1 m")).isCloseTo(0.5, within(1e-9));
        assertThat(value("leftFoot.point.left", "0.1 m")).isCloseTo(0.1, within(1e-9));
        assertThat(value("leftFoot.force.up", "50 N")).isEqualTo(GaitObservation.MAX);
        assertThat(value("rightFoot.force.up", "50 N")).isZero();
        assertThat(value("action.LEFT_HIP_YAW_PITCH", "1")).isEqualTo(0.5);
        assertThat(value("action.RIGHT_FOOT_ROLL", "1")).isEqualTo(-1);
    }

    private void see(Posture posture, TorsoMotion torso, FootPressure left) {
        observation.update(posture, torso, left, FootPressure.NONE);
    }

    private double value(String name, String unit) {
        int index = GaitObservation.INPUTS.indexOf(new Quantity(name, unit));
        assertThat(index)
                .as(name + " of " + Arrays.toString(GaitObservation.INPUTS.toArray()))
                .isNotNegative();
        return observation.values(action)[index];
    }
}
