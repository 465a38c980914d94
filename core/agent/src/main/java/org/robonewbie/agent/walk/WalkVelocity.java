package org.robonewbie.agent.walk;

/**
 * Walking velocity in the robot's frame.
 *
 * @param forward metres per second; negative is backward
 * @param left metres per second to the left; negative is to the right
 * @param turn degrees per second to the left; negative is to the right
 */
public record WalkVelocity(double forward, double left, double turn) {

    /** Zero velocity. */
    public static final WalkVelocity ZERO = new WalkVelocity(0, 0, 0);

    /** {@return whether all components are 0} */
    public boolean isZero() {
        return forward == 0 && left == 0 && turn == 0;
    }

    /**
     * Scales the velocity down to the given limits; its direction is preserved. The limits form an octahedron: a robot
     * that moves at half of one maximum speed can use at most half of the others.
     *
     * @param most maximum speeds
     * @param backward maximum backward speed in metres per second
     * @return this velocity or a slower one
     */
    public WalkVelocity within(WalkVelocity most, double backward) {
        double ahead = forward / (forward < 0 ? backward : most.forward());
        double size = Math.abs(ahead) + Math.abs(left / most.left()) + Math.abs(turn / most.turn());
        return size > 1 ? new WalkVelocity(forward / size, left / size, turn / size) : this;
    }

    /**
     * Moves towards another velocity with limited acceleration.
     *
     * @param wanted the other velocity
     * @param change maximum change in each component
     * @return the other velocity, or one between the two
     */
    public WalkVelocity towards(WalkVelocity wanted, WalkVelocity change) {
        return new WalkVelocity(
                towards(forward, wanted.forward, change.forward),
                towards(left, wanted.left, change.left),
                towards(turn, wanted.turn, change.turn));
    }

    private static double towards(double from, double to, double change) {
        return from + Math.max(-change, Math.min(change, to - from));
    }
}
