package org.robonewbie.learning.optimise;

/**
 * What a motion is for: where it brings robot and ball. A motion that shall cost less energy or rock less must go on doing it.
 *
 * @param forward metres that the robot has come forward
 * @param left metres that it has come to the left
 * @param turnedDegrees how far it has turned to the left
 * @param ballForward metres that the ball has come forward
 */
record Deed(double forward, double left, double turnedDegrees, double ballForward) {

    /** Tells how different another deed is, about 1 for something quite different. */
    double difference(Deed other) {
        return part(forward, other.forward, 0.2)
                + part(left, other.left, 0.2)
                + part(turnedDegrees, other.turnedDegrees, 20)
                + part(ballForward, other.ballForward, 0.5);
    }

    private static double part(double mine, double wanted, double usual) {
        return Math.abs(mine - wanted) / Math.max(usual, Math.abs(wanted));
    }
}
