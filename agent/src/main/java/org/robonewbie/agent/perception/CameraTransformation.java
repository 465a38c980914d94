package org.robonewbie.agent.perception;

import org.robonewbie.nao.Vector3;

/**
 * Turns what the camera in the turned head sees into what a head that looks straight ahead would see. Write your own if you
 * know better.
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
     * Turns the seen point by the neck's pitch about the axis to the left and by its yaw about the axis upwards, as the real
     * joints do. Exact but for the few millimetres by which the centre of the head lies beside the axis of pitch.
     */
    CameraTransformation ROTATION = (seen, neckYawDegrees, neckPitchDegrees) -> {
        Vector3 point = seen.toPoint();
        double pitch = Math.toRadians(neckPitchDegrees);
        double forward = point.x() * Math.cos(pitch) - point.z() * Math.sin(pitch);
        double up = point.x() * Math.sin(pitch) + point.z() * Math.cos(pitch);
        double yaw = Math.toRadians(neckYawDegrees);
        return Direction.of(new Vector3(
                forward * Math.cos(yaw) - point.y() * Math.sin(yaw),
                forward * Math.sin(yaw) + point.y() * Math.cos(yaw),
                up));
    };

    /**
     * Turns a direction from the camera's view into the view straight ahead.
     *
     * @param seen where the camera sees something; bearing 0 is where the head looks
     * @param neckYawDegrees how far the head is turned; positive is left
     * @param neckPitchDegrees how far the head is lifted; positive is up
     * @return where it is against the torso
     */
    Direction toFacingForward(Direction seen, double neckYawDegrees, double neckPitchDegrees);

    /** The same angle from -180 to 180 degrees. */
    private static double normalized(double degrees) {
        return Math.IEEEremainder(degrees, 360);
    }
}
