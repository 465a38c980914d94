package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * All constraint rows of an island in the order of elimination.
 *
 * <p>Six numbers per row and body: how fast the row's gap opens per unit of the body's linear and angular velocity. A row is
 * <i>free</i> while its force is unknown; otherwise its force is at its lower or upper limit.
 */
final class ConstraintRows {

    /** The row's force is whatever fulfils the row. */
    static final byte FREE = 0;
    /** The row's force is at its lower limit. */
    static final byte LOW = 1;
    /** The row's force is at its upper limit. */
    static final byte HIGH = 2;

    private final ScratchCapacity capacity = new ScratchCapacity(1 << 9);

    int count;
    /** For each joint in the order of elimination, whether it is a {@link ConstraintJoint#hinge}. */
    boolean[] hinge = {};
    /** Jacobian against the first body. */
    double[] first = {};
    /** Jacobian against the second body. */
    double[] second = {};
    /** Jacobian times inverse mass of the first body: its acceleration per newton of the row. */
    double[] firstResponse = {};
    /** The same for the second body. */
    double[] secondResponse = {};
    /** The speed that the row asks for; once {@link #prepare} is done, the right-hand side b. */
    double[] wanted = {};
    /** How much of that speed the row gives up per newton (ODE: CFM); once prepared, divided by the step. */
    double[] softness = {};
    /** The least force. */
    double[] lower = {};
    /** The greatest force. */
    double[] upper = {};
    /** The force that was found. */
    double[] force = {};
    /** {@link #FREE}, {@link #LOW} or {@link #HIGH}. */
    byte[] state = {};
    /** The state that the last solution suggests. */
    byte[] next = {};
    /** ScratchCapacity for the solution of the linear system. */
    double[] solution = {};

    /** Makes room for rows: unlimited, at speed 0, with the world's softness. Each joint writes all of its Jacobians. */
    void reset(int rows, int joints, double worldSoftness) {
        count = rows;
        if (hinge.length < joints) {
            hinge = new boolean[2 * joints];
        }
        int length = capacity.fit(state.length, rows);
        if (length != state.length) {
            resize(length);
        }
        Arrays.fill(wanted, 0, rows, 0);
        Arrays.fill(softness, 0, rows, worldSoftness);
        Arrays.fill(lower, 0, rows, Double.NEGATIVE_INFINITY);
        Arrays.fill(upper, 0, rows, Double.POSITIVE_INFINITY);
    }

    private void resize(int rows) {
        first = new double[6 * rows];
        second = new double[6 * rows];
        firstResponse = new double[6 * rows];
        secondResponse = new double[6 * rows];
        wanted = new double[rows];
        softness = new double[rows];
        lower = new double[rows];
        upper = new double[rows];
        force = new double[rows];
        state = new byte[rows];
        next = new byte[rows];
        solution = new double[rows];
    }

    /** Writes a vector into the linear part of a row's Jacobian. */
    static void setLinear(double[] jacobian, int row, double x, double y, double z) {
        jacobian[6 * row] = x;
        jacobian[6 * row + 1] = y;
        jacobian[6 * row + 2] = z;
    }

    /** Writes a vector into the angular part of a row's Jacobian. */
    static void setAngular(double[] jacobian, int row, double x, double y, double z) {
        jacobian[6 * row + 3] = x;
        jacobian[6 * row + 4] = y;
        jacobian[6 * row + 5] = z;
    }

    /** Computes the right-hand side and the responses of a joint's rows; the bodies are prepared. */
    void prepare(ConstraintJoint joint, double rate) {
        Body one = joint.first;
        Body two = joint.second;
        int from = joint.firstRow;
        int to = from + joint.rowCount();
        if (joint.hinge && two != null) {
            respondHinge(one, first, firstResponse, from);
            respondHinge(two, second, secondResponse, from);
            demandHinge(from, one.unconstrained, two.unconstrained, rate);
        } else {
            respond(one, first, firstResponse, from, to);
            if (two != null) {
                respond(two, second, secondResponse, from, to);
            }
            for (int row = from; row < to; row++) {
                double free = dot6(first, 6 * row, one.unconstrained);
                if (two != null) {
                    free += dot6(second, 6 * row, two.unconstrained);
                }
                wanted[row] = wanted[row] * rate - free;
            }
        }
        for (int row = from; row < to; row++) {
            softness[row] *= rate;
        }
    }

    private void demandHinge(int row, double[] one, double[] two, double rate) {
        int at = 6 * row;
        double along = first[at];
        for (int axis = 0; axis < 3; axis++) {
            int angular = at + 6 * axis + 3;
            double free = along * one[axis] + Rotations.dot(first, angular, one, 3);
            free += -along * two[axis] + Rotations.dot(second, angular, two, 3);
            wanted[row + axis] = wanted[row + axis] * rate - free;
        }
        for (int turn = 3; turn < 6; turn++) {
            int angular = at + 6 * turn + 3;
            double free = Rotations.dot(first, angular, one, 3) + Rotations.dot(second, angular, two, 3);
            wanted[row + turn] = wanted[row + turn] * rate - free;
        }
    }

    private static void respond(Body body, double[] jacobian, double[] response, int from, int to) {
        double mass = body.inverseMass;
        for (int at = 6 * from; at < 6 * to; at += 6) {
            response[at] = jacobian[at] * mass;
            response[at + 1] = jacobian[at + 1] * mass;
            response[at + 2] = jacobian[at + 2] * mass;
        }
        turn(body.inverseInertia, jacobian, response, 6 * from, 6 * to);
    }

    /** A hinge moves bodies along one axis of the world in each of its first rows, and not at all in the others. */
    private static void respondHinge(Body body, double[] jacobian, double[] response, int row) {
        int at = 6 * row;
        double move = jacobian[at] * body.inverseMass;
        setLinear(response, row, move, 0, 0);
        setLinear(response, row + 1, 0, move, 0);
        setLinear(response, row + 2, 0, 0, move);
        setLinear(response, row + 3, 0, 0, 0);
        setLinear(response, row + 4, 0, 0, 0);
        setLinear(response, row + 5, 0, 0, 0);
        turn(body.inverseInertia, jacobian, response, at, at + 36);
    }

    private static void turn(double[] inverse, double[] jacobian, double[] response, int from, int to) {
        double xx = inverse[0];
        double xy = inverse[1];
        double xz = inverse[2];
        double yx = inverse[3];
        double yy = inverse[4];
        double yz = inverse[5];
        double zx = inverse[6];
        double zy = inverse[7];
        double zz = inverse[8];
        for (int at = from; at < to; at += 6) {
            double x = jacobian[at + 3];
            double y = jacobian[at + 4];
            double z = jacobian[at + 5];
            response[at + 3] = xx * x + xy * y + xz * z;
            response[at + 4] = yx * x + yy * y + yz * z;
            response[at + 5] = zx * x + zy * y + zz * z;
        }
    }

    static double dot6(double[] jacobian, int at, double[] motion) {
        return dot6(jacobian, at, motion, 0);
    }

    static double dot6(double[] jacobian, int at, double[] motions, int from) {
        return Rotations.dot(jacobian, at, motions, from) + Rotations.dot(jacobian, at + 3, motions, from + 3);
    }
}
