package org.robonewbie.agent.walk;

import org.robonewbie.agent.perception.TorsoMotion;

/**
 * The sense of balance: how the torso leans, from gyro and accelerometer. The gyro's turning is added up cycle by cycle; since
 * its errors add up too, the sum is slowly drawn towards the direction of gravity that the accelerometer feels (a
 * complementary filter). Knocks of the feet are cut off.
 */
final class Balance {

    private static final double CYCLE_SECONDS = 0.02;
    private static final double TRUST_SECONDS = 0.8;
    private static final double RATE_SMOOTHING = 0.4;
    private static final double WEAKEST = 5;
    private static final double STRONGEST = 20;

    private double pitchDegrees;
    private double rollDegrees;
    private double pitchRate;
    private double rollRate;

    /** Takes in the readings of a cycle. */
    void feel(TorsoMotion torso) {
        pitchDegrees += torso.pitchRate() * CYCLE_SECONDS;
        rollDegrees += torso.rollRate() * CYCLE_SECONDS;
        pitchRate += RATE_SMOOTHING * (torso.pitchRate() - pitchRate);
        rollRate += RATE_SMOOTHING * (torso.rollRate() - rollRate);
        double strength = torso.strength();
        if (strength > WEAKEST && strength < STRONGEST) {
            double trust = CYCLE_SECONDS / TRUST_SECONDS;
            pitchDegrees += trust * (degrees(-torso.forward(), torso.up()) - pitchDegrees);
            rollDegrees += trust * (degrees(torso.left(), torso.up()) - rollDegrees);
        }
    }

    /** Forgets everything, as after a fall. */
    void reset() {
        pitchDegrees = 0;
        rollDegrees = 0;
        pitchRate = 0;
        rollRate = 0;
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

    private static double degrees(double aside, double up) {
        return Math.toDegrees(Math.atan2(aside, Math.max(1, up)));
    }
}
