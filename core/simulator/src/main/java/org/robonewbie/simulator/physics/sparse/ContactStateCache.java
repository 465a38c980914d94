package org.robonewbie.simulator.physics.sparse;

/**
 * Row states of a shape's contacts with the static environment in the previous step, used to warm-start the LCP solver.
 *
 * <p>Results do not depend on the initial basis, so the cache is not part of the world's state.
 */
final class ContactStateCache {

    private static final int MAX_POINTS = 4;
    private static final double MAX_DISTANCE = 1e-3;

    private final double[] points = new double[3 * MAX_POINTS];
    private final byte[] states = new byte[MAX_POINTS];
    private final double[] local = new double[3];
    private int count;

    void clear() {
        count = 0;
    }

    /**
     * Stores the state of a contact.
     *
     * @param body the body of the shape
     * @param point contact point in the world frame
     * @param state state of the normal row
     */
    void add(Body body, double[] point, byte state) {
        if (count < MAX_POINTS) {
            body.toLocal(point, points, 3 * count);
            states[count++] = state;
        }
    }

    /** Returns the state of the normal row of a stored contact within 1 mm of a point; free if there is no such contact. */
    byte stateAt(Body body, double[] point) {
        if (count > 0) {
            body.toLocal(point, local, 0);
        }
        for (int i = 0; i < count; i++) {
            int at = 3 * i;
            double distance = Math.abs(local[0] - points[at])
                    + Math.abs(local[1] - points[at + 1])
                    + Math.abs(local[2] - points[at + 2]);
            if (distance < MAX_DISTANCE) {
                return states[i];
            }
        }
        return ConstraintRows.FREE;
    }
}
