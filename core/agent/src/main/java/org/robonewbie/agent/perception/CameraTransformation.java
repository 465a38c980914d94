package org.robonewbie.agent.perception;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.model.RobotType;

/**
 * Converts what the camera in the turned head sees to what a head that looks straight ahead would see. Implement it to try a
 * better one.
 */
@FunctionalInterface
public interface CameraTransformation {

    /**
     * Adds the angles of the neck to those of the camera: bearing = horizontal angle + neck yaw, elevation = vertical angle +
     * neck pitch.
     *
     * <p>This is simple and good enough to find a ball. It is exact while the neck pitch is 0, and for everything straight
     * ahead of the head. With the head bent down by 40° an object 2 m away that the camera sees 45° aside is taken to be 0.5 m
     * from where it is.
     */
    CameraTransformation SUM_OF_ANGLES = (seen, neckYawDegrees, neckPitchDegrees) -> new Direction(
            seen.distance(), normalized(seen.bearing() + neckYawDegrees), seen.elevation() + neckPitchDegrees);

    /**
     * Follows the real chain of the neck's joints from the camera to the torso. Exact, as long as the torso is upright.
     */
    CameraTransformation KINEMATICS = (seen, neckYawDegrees, neckPitchDegrees) -> {
        ForwardKinematics robot = ForwardKinematics.of(RobotType.TYPE_0);
        Vector3 point = robot.camera(neckYawDegrees, neckPitchDegrees).transform(seen.toPoint());
        return Direction.of(point.minus(robot.camera(0, 0).position()));
    };

    /**
     * Converts a direction from the camera's view to the view straight ahead.
     *
     * @param seen where the camera sees something; bearing 0 is where the head looks
     * @param neckYawDegrees angle of the neck; positive is left
     * @param neckPitchDegrees angle of the neck; positive is up
     * @return its direction relative to the torso
     */
    Direction toFacingForward(Direction seen, double neckYawDegrees, double neckPitchDegrees);

    /** The same angle from -180 to 180 degrees. */
    private static double normalized(double degrees) {
        return Angles.wrap(degrees);
    }
}
