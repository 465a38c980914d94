package org.robonewbie.simulator.physics.sparse;

/**
 * Counts at how many points an assembly touches others within a step.
 *
 * <p>Many robots that were put into each other touch at thousands of points, which would take minutes and all memory; so only some
 * of them push, and the robots come apart all the same. Nothing is left out where all robots together touch at few points.
 */
final class ContactBudget {

    private static final int MOST_POINTS = 64;

    private long step;
    private int points;

    /** Whether more points may push in this step. */
    boolean hasRoom(long thisStep) {
        return step != thisStep || points < MOST_POINTS;
    }

    /** Notes points that push. */
    void add(long thisStep, int more) {
        points = step == thisStep ? points + more : more;
        step = thisStep;
    }
}
