package org.robonewbie.agent.cycle;

import org.robonewbie.nao.kinematics.Pose;

/** Forward kinematics of a robot's neck. */
@FunctionalInterface
public interface CameraKinematics {

    /**
     * Returns where the camera is.
     *
     * @param neckYawDegrees yaw angle of the neck; positive is left
     * @param neckPitchDegrees pitch angle of the neck; positive is up
     * @return pose of the camera in the torso's frame
     */
    Pose pose(double neckYawDegrees, double neckPitchDegrees);
}
