package org.robonewbie.agent.perception;

import org.robonewbie.nao.Vector3;

/**
 * What gyroscope and accelerometer in the torso feel. The same object takes in the readings of each cycle, so that feeling makes
 * no garbage; x is forward, y to the left and z up.
 */
public final class TorsoMotion {

    private static final double GRAVITY = 9.81;

    private double rollRate;
    private double pitchRate;
    private double yawRate;
    private double forward;
    private double left;
    private double up = GRAVITY;

    /** Creates the readings of a robot that stands still. */
    public TorsoMotion() {}

    /**
     * Takes in a reading of the gyroscope.
     *
     * @param newRollRate degrees per second with which the right side goes down
     * @param newPitchRate degrees per second with which the torso bends forward
     * @param newYawRate degrees per second with which the torso turns left
     */
    public void setGyro(double newRollRate, double newPitchRate, double newYawRate) {
        rollRate = newRollRate;
        pitchRate = newPitchRate;
        yawRate = newYawRate;
    }

    /**
     * Takes in a reading of the accelerometer.
     *
     * @param newForward m/s² to the front
     * @param newLeft m/s² to the left
     * @param newUp m/s² upwards; 9.81 for a robot that stands still
     */
    public void setAcceleration(double newForward, double newLeft, double newUp) {
        forward = newForward;
        left = newLeft;
        up = newUp;
    }

    /**
     * Gives the reading of the gyroscope.
     *
     * @return degrees per second about the axes x, y and z
     */
    public Vector3 gyro() {
        return new Vector3(rollRate, pitchRate, yawRate);
    }

    /**
     * Gives the reading of the accelerometer.
     *
     * @return m/s² along the axes x, y and z
     */
    public Vector3 acceleration() {
        return new Vector3(forward, left, up);
    }

    /**
     * Tells how fast the torso leans.
     *
     * @return degrees per second with which the right side goes down
     */
    public double rollRate() {
        return rollRate;
    }

    /**
     * Tells how fast the torso bows.
     *
     * @return degrees per second with which it bends forward
     */
    public double pitchRate() {
        return pitchRate;
    }

    /**
     * Tells how the torso is pushed forward.
     *
     * @return m/s²
     */
    public double forward() {
        return forward;
    }

    /**
     * Tells how the torso is pushed to the left.
     *
     * @return m/s²
     */
    public double left() {
        return left;
    }

    /**
     * Tells how the torso is pushed upwards.
     *
     * @return m/s²; 9.81 for a robot that stands still
     */
    public double up() {
        return up;
    }

    /**
     * Tells how strongly the torso is pushed, whereto ever.
     *
     * @return m/s²
     */
    public double strength() {
        return Math.sqrt(forward * forward + left * left + up * up);
    }
}
