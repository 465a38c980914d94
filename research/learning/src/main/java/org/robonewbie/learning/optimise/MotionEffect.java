package org.robonewbie.learning.optimise;

/**
 * Effect of a motion on the position of robot and ball, which must be preserved when energy or sway are minimised.
 *
 * @param forward forward motion of the robot, in metres
 * @param left motion of the robot to the left, in metres
 * @param turnedDegrees rotation of the robot to the left, in degrees
 * @param ballForward forward motion of the ball, in metres
 */
record MotionEffect(double forward, double left, double turnedDegrees, double ballForward) {

    /** The difference from another effect; values about 1 indicate a different motion. */
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
