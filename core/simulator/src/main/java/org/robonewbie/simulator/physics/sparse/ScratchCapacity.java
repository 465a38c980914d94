package org.robonewbie.simulator.physics.sparse;

/**
 * How long an array has to be that is used again and again for islands of all sizes: it grows at once, and shrinks when it
 * has been far too long for so many islands that the pile of robots for which it grew is gone.
 */
final class ScratchCapacity {

    private static final int PATIENCE = 2_000;
    private static final int FAR_TOO_LONG = 4;

    private final int least;
    private int wasted;

    /**
     * Sets a lower limit.
     *
     * @param least length below which nothing is worth shrinking
     */
    ScratchCapacity(int least) {
        this.least = least;
    }

    /**
     * Chooses a length.
     *
     * @param present how long the array is
     * @param needed how much of it the next island needs
     * @return the present length if it may stay as it is, or another one that is at least as much as needed
     */
    int fit(int present, int needed) {
        boolean wasteful = present > least && needed < present / FAR_TOO_LONG;
        wasted = wasteful ? wasted + 1 : 0;
        if (needed <= present && wasted < PATIENCE) {
            return present;
        }
        wasted = 0;
        return Math.max(least, needed + needed / 2);
    }
}
