package org.robonewbie.simulator.physics.sparse;

/**
 * Limits the contact points of an assembly within a step.
 *
 * <p>Many robots that were put into each other touch at thousands of points, which would take minutes and all memory. With the
 * limit only some of them push, and the robots still separate.
 */
final class ContactLimit {

    private static final int MAX_POINTS = 64;

    private long step;
    private int points;

    /** Whether more points may be added in this step. */
    boolean hasRoom(long thisStep) {
        return step != thisStep || points < MAX_POINTS;
    }

    /** Counts points. */
    void add(long thisStep, int more) {
        points = step == thisStep ? points + more : more;
        step = thisStep;
    }
}
