package org.robonewbie.agent.walk;

/**
 * How fast and into which direction a robot walks.
 *
 * @param forward metres per second; negative is backward
 * @param left metres per second to the left; negative is to the right
 * @param turn degrees per second to the left; negative is to the right
 */
public record WalkVelocity(double forward, double left, double turn) {

    /** Standing still. */
    public static final WalkVelocity ZERO = new WalkVelocity(0, 0, 0);

    /**
     * Tells whether this is no walking at all.
     *
     * @return whether all three speeds are 0
     */
    public boolean isZero() {
        return forward == 0 && left == 0 && turn == 0;
    }

    /**
     * Slows down to what a robot can do, without changing the direction.
     *
     * @param most the largest speeds; who uses half of one has half of the others left
     * @param backward the largest speed backward, metres per second
     * @return this velocity or a slower one
     */
    public WalkVelocity within(WalkVelocity most, double backward) {
        Pace pace = new Pace();
        pace.set(forward, left, turn);
        pace.limit(most, backward);
        return new WalkVelocity(pace.forward(), pace.left(), pace.turn());
    }
}
