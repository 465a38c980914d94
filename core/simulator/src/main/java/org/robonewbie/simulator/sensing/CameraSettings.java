package org.robonewbie.simulator.sensing;

/**
 * Settings of a camera (SimSpark: {@code naoneckhead.rsg}).
 *
 * @param horizontalConeDegrees full horizontal angle of view, below 180
 * @param verticalConeDegrees full vertical angle of view, below 180
 * @param noise whether distances and angles are noisy and the camera has a calibration error
 * @param lines whether the field lines are reported
 * @param ownPosition whether the true position of the robot's own head is reported
 * @param ownOrientation whether the true direction of the robot's own head is reported
 * @param ballPosition whether the true position of the ball is reported
 */
public record CameraSettings(
        double horizontalConeDegrees,
        double verticalConeDegrees,
        boolean noise,
        boolean lines,
        boolean ownPosition,
        boolean ownOrientation,
        boolean ballPosition) {

    /** The NAO's camera in rcssserver3d. */
    public static final CameraSettings STANDARD = new CameraSettings(120, 120, true, true, false, false, false);

    /** Number of cycles between images. */
    public static final int CYCLES_PER_PICTURE = 3;

    /**
     * Returns a copy with or without noise.
     *
     * @param on whether there is noise
     * @return the changed settings
     */
    public CameraSettings withNoise(boolean on) {
        return new CameraSettings(
                horizontalConeDegrees, verticalConeDegrees, on, lines, ownPosition, ownOrientation, ballPosition);
    }

    /**
     * Returns a copy with or without field lines.
     *
     * @param on whether field lines are reported
     * @return the changed settings
     */
    public CameraSettings withLines(boolean on) {
        return new CameraSettings(
                horizontalConeDegrees, verticalConeDegrees, noise, on, ownPosition, ownOrientation, ballPosition);
    }

    /**
     * Returns a copy that reports the selected ground-truth values, which a real camera cannot provide.
     *
     * @param ownPositionOn whether the true position of the robot's own head is reported
     * @param ownOrientationOn whether the true direction of the robot's own head is reported
     * @param ballPositionOn whether the true position of the ball is reported
     * @return the changed settings
     */
    public CameraSettings withTruth(boolean ownPositionOn, boolean ownOrientationOn, boolean ballPositionOn) {
        return new CameraSettings(
                horizontalConeDegrees,
                verticalConeDegrees,
                noise,
                lines,
                ownPositionOn,
                ownOrientationOn,
                ballPositionOn);
    }
}
