package org.robonewbie.agent.walk;

import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;

/**
 * The sense of balance: how the torso leans, from gyro and accelerometer. The gyro's turning is added up cycle by cycle; since
 * its errors add up too, the sum is slowly drawn towards the direction of gravity that the accelerometer feels (a
 * complementary filter). Knocks of the feet are cut off.
 */
final class Balance {

    private static final double TRUST_SECONDS = 0.8;
    private static final double RATE_SMOOTHING = 0.4;
    private static final double WEAKEST = 5;
    private static final double STRONGEST = 20;

    private double pitchDegrees;
    private double rollDegrees;
    private double pitchRate;
    private double rollRate;
    private double turnRate;

    /** Takes in the readings of a cycle. */
    void update(TorsoMotion torso) {
        pitchDegrees += torso.gyro().y() * Cycle.SECONDS;
        rollDegrees += torso.gyro().x() * Cycle.SECONDS;
        pitchRate += RATE_SMOOTHING * (torso.gyro().y() - pitchRate);
        rollRate += RATE_SMOOTHING * (torso.gyro().x() - rollRate);
        turnRate += RATE_SMOOTHING * (torso.gyro().z() - turnRate);
        Vector3 up = torso.acceleration();
        double strength = up.length();
        if (strength > WEAKEST && strength < STRONGEST) {
            double trust = Cycle.SECONDS / TRUST_SECONDS;
            pitchDegrees += trust * (degrees(-up.x(), up.z()) - pitchDegrees);
            rollDegrees += trust * (degrees(up.y(), up.z()) - rollDegrees);
        }
    }

    /** Forgets everything, as after a fall. */
    void reset() {
        pitchDegrees = 0;
        rollDegrees = 0;
        pitchRate = 0;
        rollRate = 0;
        turnRate = 0;
    }

    /** How far the torso bows forward, degrees. */
    double pitchDegrees() {
        return pitchDegrees;
    }

    /** How far the torso leans to the right, degrees. */
    double rollDegrees() {
        return rollDegrees;
    }

    /** How fast the torso bows forward, degrees per second. */
    double pitchRate() {
        return pitchRate;
    }

    /** How fast the torso leans to the right, degrees per second. */
    double rollRate() {
        return rollRate;
    }

    /** How fast the torso turns to the left, degrees per second. */
    double turnRate() {
        return turnRate;
    }

    private static double degrees(double aside, double up) {
        return Angles.atan2(aside, Math.max(1, up));
    }
}
