package org.robonewbie.agent.perception;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.Vector3;

class FallDetectorTest {

    private final FallDetector detector = new FallDetector();

    @ParameterizedTest
    @CsvSource({
        "0, 0, 9.81, UPRIGHT",
        "9.81, 0, 0, LYING_ON_BACK",
        "-9.81, 0, 0, LYING_ON_FRONT",
        "0, -9.81, 0, LYING_ON_LEFT_SIDE",
        "0, 9.81, 0, LYING_ON_RIGHT_SIDE"
    })
    void knowsOnWhichSideTheRobotLies(double x, double y, double z, BodyPosition expected) {
        feelForHalfASecond(new Vector3(x, y, z));

        assertThat(detector.bodyPosition()).isEqualTo(expected);
        assertThat(detector.bodyPosition().isFallen()).isEqualTo(expected != BodyPosition.UPRIGHT);
    }

    @Test
    void isNotDeceivedByAKnockOfTheFoot() {
        feelForHalfASecond(new Vector3(0, 0, 9.81));

        feel(300, -200, 5);
        feel(-100, 400, 60);

        assertThat(detector.bodyPosition()).isEqualTo(BodyPosition.UPRIGHT);
    }

    @Test
    void ignoresReadingsThatAreNoNumbers() {
        feelForHalfASecond(new Vector3(Double.NaN, 0, Double.POSITIVE_INFINITY));

        assertThat(detector.tiltDegrees()).isZero();
    }

    @Test
    void measuresHowFarTheTorsoLeans() {
        for (int i = 0; i < 200; i++) {
            feel(9.81 * Math.sin(Math.toRadians(30)), 0, 9.81 * Math.cos(Math.toRadians(30)));
        }

        assertThat(detector.tiltDegrees()).isCloseTo(30, within(0.01));
    }

    private void feelForHalfASecond(Vector3 acceleration) {
        for (int i = 0; i < 25; i++) {
            feel(acceleration.x(), acceleration.y(), acceleration.z());
        }
    }

    private void feel(double forward, double left, double up) {
        detector.update(TorsoMotion.AT_REST.withAcceleration(new Vector3(forward, left, up)));
    }
}
