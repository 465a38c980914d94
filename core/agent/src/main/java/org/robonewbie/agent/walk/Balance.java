package org.robonewbie.agent.walk;

import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;

/**
 * Complementary filter for the tilt of the torso: the gyroscope's rates are integrated, and the drift of the integral
 * is slowly corrected towards the direction of gravity measured by the accelerometer. Accelerometer readings during
 * foot impacts are ignored.
 */
final class Balance {

    private static final double TRUST_SECONDS = 0.8;
    private static final double RATE_SMOOTHING = 0.4;
    private static final double MIN_ACCELERATION = 5;
    private static final double MAX_ACCELERATION = 20;

    private double pitchDegrees;
    private double rollDegrees;
    private double pitchRate;
    private double rollRate;
    private double turnRate;

    /** Adds the readings of a cycle. */
    void update(TorsoMotion torso) {
        pitchDegrees += torso.gyro().y() * Cycle.SECONDS;
        rollDegrees += torso.gyro().x() * Cycle.SECONDS;
        pitchRate += RATE_SMOOTHING * (torso.gyro().y() - pitchRate);
        rollRate += RATE_SMOOTHING * (torso.gyro().x() - rollRate);
        turnRate += RATE_SMOOTHING * (torso.gyro().z() - turnRate);
        Vector3 up = torso.acceleration();
        double strength = up.length();
        if (strength > MIN_ACCELERATION && strength < MAX_ACCELERATION) {
            double trust = Cycle.SECONDS / TRUST_SECONDS;
            pitchDegrees += trust * (degrees(-up.x(), up.z()) - pitchDegrees);
            rollDegrees += trust * (degrees(up.y(), up.z()) - rollDegrees);
        }
    }

    void reset() {
        pitchDegrees = 0;
        rollDegrees = 0;
        pitchRate = 0;
        rollRate = 0;
        turnRate = 0;
    }

    /** Returns the forward tilt of the torso in degrees. */
    double pitchDegrees() {
        return pitchDegrees;
    }

    /** Returns the tilt of the torso to the right in degrees. */
    double rollDegrees() {
        return rollDegrees;
    }

    /** Returns the rate of the forward tilt in degrees per second. */
    double pitchRate() {
        return pitchRate;
    }

    /** Returns the rate of the tilt to the right in degrees per second. */
    double rollRate() {
        return rollRate;
    }

    /** Returns the turn rate to the left in degrees per second. */
    double turnRate() {
        return turnRate;
    }

    private static double degrees(double aside, double up) {
        return Angles.atan2(aside, Math.max(1, up));
    }
}
