package org.robonewbie.simulator.physics.sparse;

/**
 * Limit on the number of contact points of an assembly per step.
 *
 * <p>Robots that are placed inside each other touch at thousands of points, and solving for all of them would take minutes and
 * exhaust the memory. A subset of the contacts is enough to separate them.
 */
final class ContactLimit {

    private static final int MAX_POINTS = 64;

    private long step;
    private int points;

    boolean hasRoom(long thisStep) {
        return step != thisStep || points < MAX_POINTS;
    }

    void add(long thisStep, int more) {
        points = step == thisStep ? points + more : more;
        step = thisStep;
    }
}
