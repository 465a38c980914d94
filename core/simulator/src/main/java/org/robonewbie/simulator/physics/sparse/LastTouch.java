package org.robonewbie.simulator.physics.sparse;

/**
 * At which points of a shape something that never moves pushed when both touched last.
 *
 * <p>It is where the solver begins to look, and no result depends on it; so it is no part of the world's state.
 */
final class LastTouch {

    private static final int MAX_POINTS = 4;
    private static final double NEAR = 1e-3;

    private final double[] places = new double[3 * MAX_POINTS];
    private final byte[] states = new byte[MAX_POINTS];
    private final double[] place = new double[3];
    private int count;

    /** Forgets all points. */
    void clear() {
        count = 0;
    }

    /**
     * Remembers a point.
     *
     * @param body the body of the shape
     * @param point where it is, in the world
     * @param state the state of the row along its normal
     */
    void add(Body body, double[] point, byte state) {
        if (count < MAX_POINTS) {
            locate(body, point);
            System.arraycopy(place, 0, places, 3 * count, 3);
            states[count++] = state;
        }
    }

    /** The last state of the row along the normal of a point, which was free if there was none at this place of the shape. */
    byte stateAt(Body body, double[] point) {
        if (count > 0) {
            locate(body, point);
        }
        for (int i = 0; i < count; i++) {
            int at = 3 * i;
            double distance = Math.abs(place[0] - places[at])
                    + Math.abs(place[1] - places[at + 1])
                    + Math.abs(place[2] - places[at + 2]);
            if (distance < NEAR) {
                return states[i];
            }
        }
        return ConstraintRows.FREE;
    }

    /** Sees a point along the body's own axes. */
    private void locate(Body body, double[] point) {
        double[] centre = body.place();
        double[] turn = body.rotation;
        double x = point[0] - centre[0];
        double y = point[1] - centre[1];
        double z = point[2] - centre[2];
        place[0] = turn[0] * x + turn[3] * y + turn[6] * z;
        place[1] = turn[1] * x + turn[4] * y + turn[7] * z;
        place[2] = turn[2] * x + turn[5] * y + turn[8] * z;
    }
}
