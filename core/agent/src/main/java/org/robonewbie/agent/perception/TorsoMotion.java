package org.robonewbie.agent.perception;

import org.robonewbie.nao.Vector3;

/**
 * Readings of the gyroscope and the accelerometer in the torso; x is forward, y left and z up.
 *
 * @param gyro angular velocity in degrees per second: x is positive while the torso tilts to its right, y while it tilts
 *     forward, z while it turns left
 * @param acceleration specific force in m/s²: (0, 0, 9.81) at rest
 */
public record TorsoMotion(Vector3 gyro, Vector3 acceleration) {

    /** Readings of a robot at rest. */
    public static final TorsoMotion AT_REST = new TorsoMotion(Vector3.ZERO, new Vector3(0, 0, 9.81));

    /**
     * Returns a copy with the given gyroscope reading.
     *
     * @param newGyro angular velocity in degrees per second
     * @return the new readings
     */
    public TorsoMotion withGyro(Vector3 newGyro) {
        return new TorsoMotion(newGyro, acceleration);
    }

    /**
     * Returns a copy with the given accelerometer reading.
     *
     * @param newAcceleration specific force in m/s²
     * @return the new readings
     */
    public TorsoMotion withAcceleration(Vector3 newAcceleration) {
        return new TorsoMotion(gyro, newAcceleration);
    }
}
