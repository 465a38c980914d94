package org.robonewbie.agent.perception;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.model.RobotType;

/**
 * Converts directions relative to a turned head to directions relative to a head facing straight ahead. Implement this
 * interface to try a better conversion.
 */
@FunctionalInterface
public interface CameraTransformation {

    /**
     * Adds the angles of the neck to those of the camera: bearing = horizontal angle + neck yaw, elevation = vertical angle +
     * neck pitch.
     *
     * <p>This approximation is good enough to find a ball. It is exact while the neck pitch is 0, and for objects
     * straight ahead of the head. With the head pitched down by 40°, an object 2 m away that the camera sees 45° to the
     * side is misplaced by 0.5 m.
     */
    CameraTransformation SUM_OF_ANGLES = (seen, neckYawDegrees, neckPitchDegrees) -> new Direction(
            seen.distance(), Angles.wrap(seen.bearing() + neckYawDegrees), seen.elevation() + neckPitchDegrees);

    /** Applies the forward kinematics of the neck from the camera to the torso. Exact as long as the torso is upright. */
    CameraTransformation KINEMATICS = (seen, neckYawDegrees, neckPitchDegrees) -> {
        ForwardKinematics robot = ForwardKinematics.of(RobotType.TYPE_0);
        Vector3 point = robot.camera(neckYawDegrees, neckPitchDegrees).transform(seen.toPoint());
        return Direction.of(point.minus(robot.camera(0, 0).position()));
    };

    /**
     * Converts a direction relative to the head to the direction relative to a head facing straight ahead.
     *
     * @param seen direction of an object relative to the head; bearing 0 is straight ahead of the head
     * @param neckYawDegrees yaw angle of the neck; positive is left
     * @param neckPitchDegrees pitch angle of the neck; positive is up
     * @return the object's direction relative to the torso
     */
    Direction toFacingForward(Direction seen, double neckYawDegrees, double neckPitchDegrees);
}
