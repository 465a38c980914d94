package org.robonewbie.learning.optimise;

/**
 * Effect of a motion on the positions of the robot and the ball. It must be preserved when energy or sway is minimised.
 *
 * @param forward forward motion of the robot, in metres
 * @param left motion of the robot to the left, in metres
 * @param turnedDegrees rotation of the robot to the left, in degrees
 * @param ballForward forward motion of the ball, in metres
 */
record MotionEffect(double forward, double left, double turnedDegrees, double ballForward) {

    /** Returns the difference from another effect; values around 1 or more indicate a different motion. */
    double difference(MotionEffect other) {
        return part(forward, other.forward, 0.2)
                + part(left, other.left, 0.2)
                + part(turnedDegrees, other.turnedDegrees, 20)
                + part(ballForward, other.ballForward, 0.5);
    }

    private static double part(double value, double reference, double minScale) {
        return Math.abs(value - reference) / Math.max(minScale, Math.abs(reference));
    }
}
