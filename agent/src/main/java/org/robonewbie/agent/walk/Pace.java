package org.robonewbie.agent.walk;

/** A {@link WalkVelocity} that changes while the robot walks, so that no step makes garbage. */
final class Pace {

    private double forward;
    private double left;
    private double turn;

    /** Metres per second; negative is backward. */
    double forward() {
        return forward;
    }

    /** Metres per second to the left. */
    double left() {
        return left;
    }

    /** Degrees per second to the left. */
    double turn() {
        return turn;
    }

    boolean isZero() {
        return forward == 0 && left == 0 && turn == 0;
    }

    void set(double newForward, double newLeft, double newTurn) {
        forward = newForward;
        left = newLeft;
        turn = newTurn;
    }

    /** Slows down to what a robot can do, without changing the direction; see {@link WalkVelocity#within}. */
    void limit(WalkVelocity most, double backward) {
        double ahead = forward / (forward < 0 ? backward : most.forward());
        double size = Math.abs(ahead) + Math.abs(left / most.left()) + Math.abs(turn / most.turn());
        if (size > 1) {
            set(forward / size, left / size, turn / size);
        }
    }

    /** Comes nearer to another velocity, in each speed by a limited change. */
    void approach(Pace wanted, WalkVelocity change) {
        forward = approach(forward, wanted.forward, change.forward());
        left = approach(left, wanted.left, change.left());
        turn = approach(turn, wanted.turn, change.turn());
    }

    private static double approach(double from, double to, double change) {
        return from + Math.max(-change, Math.min(change, to - from));
    }
}
