package org.robonewbie.agent.perception;

import org.robonewbie.nao.Vector3;

/**
 * The readings of gyroscope and accelerometer in the torso; x is forward, y to the left and z up.
 *
 * @param gyro angular velocity in degrees per second: x is positive while the right side goes down, y while the torso bends
 *     forward, z while it turns left
 * @param acceleration specific force in m/s²: (0, 0, 9.81) at rest
 */
public record TorsoMotion(Vector3 gyro, Vector3 acceleration) {

    /** The readings of a robot at rest. */
    public static final TorsoMotion AT_REST = new TorsoMotion(Vector3.ZERO, new Vector3(0, 0, 9.81));

    /**
     * Replaces the reading of the gyroscope.
     *
     * @param newGyro degrees per second
     * @return the new readings
     */
    public TorsoMotion withGyro(Vector3 newGyro) {
        return new TorsoMotion(newGyro, acceleration);
    }

    /**
     * Replaces the reading of the accelerometer.
     *
     * @param newAcceleration m/s²
     * @return the new readings
     */
    public TorsoMotion withAcceleration(Vector3 newAcceleration) {
        return new TorsoMotion(gyro, newAcceleration);
    }
}
