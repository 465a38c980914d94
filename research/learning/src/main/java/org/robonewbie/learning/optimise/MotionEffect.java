package org.robonewbie.learning.optimise;

/**
 * The effect of a motion: where it brings robot and ball. A motion that is to cost less energy or rock less must keep this
 * effect.
 *
 * @param forward metres that the robot has moved forward
 * @param left metres that it has moved to the left
 * @param turnedDegrees degrees that it has turned to the left
 * @param ballForward metres that the ball has moved forward
 */
record MotionEffect(double forward, double left, double turnedDegrees, double ballForward) {

    /** The difference from another effect, about 1 for something quite different. */
    double difference(MotionEffect other) {
        return part(forward, other.forward, 0.2)
                + part(left, other.left, 0.2)
                + part(turnedDegrees, other.turnedDegrees, 20)
                + part(ballForward, other.ballForward, 0.5);
    }

    private static double part(double mine, double wanted, double usual) {
        return Math.abs(mine - wanted) / Math.max(usual, Math.abs(wanted));
    }
}
