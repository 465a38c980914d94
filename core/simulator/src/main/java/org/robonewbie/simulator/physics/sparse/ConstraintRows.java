package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * Constraint rows of an island in elimination order.
 *
 * <p>A Jacobian row has six elements per body: the speed of the constraint per unit of linear and angular velocity. A row
 * is <i>free</i> (basic) if its force is to be solved for; otherwise its force is at its lower or upper limit.
 */
final class ConstraintRows {

    /** The force is chosen such that the row is satisfied. */
    static final byte FREE = 0;
    /** The force is at its lower limit. */
    static final byte LOW = 1;
    /** The force is at its upper limit. */
    static final byte HIGH = 2;

    private final ScratchCapacity capacity = new ScratchCapacity(1 << 9);

    int count;
    /** Whether each joint, in elimination order, is a {@link ConstraintJoint#hinge}. */
    boolean[] hinge = {};

    double[] firstJacobian = {};
    double[] secondJacobian = {};
    /** M⁻¹ Jᵀ for the first body: its acceleration per newton of the row's force. */
    double[] firstResponse = {};
    /** M⁻¹ Jᵀ for the second body. */
    double[] secondResponse = {};
    /** Target speed c; after {@link #prepare}, the right-hand side b. */
    double[] rightHandSide = {};
    /**
     * Constraint force mixing C in metres per second per newton (ODE: CFM); after {@link #prepare}, divided by the
     * duration of the step.
     */
    double[] softness = {};

    double[] lower = {};
    double[] upper = {};
    double[] force = {};
    /** {@link #FREE}, {@link #LOW} or {@link #HIGH}. */
    byte[] state = {};
    /** State of each row for the next iteration, as suggested by the last one. */
    byte[] nextState = {};
    /** Right-hand side of the linear system and, after it has been solved, its solution. */
    double[] solution = {};

    /** Resets rows to unlimited forces, target speed 0 and a default softness. Jacobians keep their old values. */
    void reset(int rows, int joints, double defaultSoftness) {
        count = rows;
        if (hinge.length < joints) {
            hinge = new boolean[2 * joints];
        }
        int length = capacity.fit(state.length, rows);
        if (length != state.length) {
            resize(length);
        }
        Arrays.fill(rightHandSide, 0, rows, 0);
        Arrays.fill(softness, 0, rows, defaultSoftness);
        Arrays.fill(lower, 0, rows, Double.NEGATIVE_INFINITY);
        Arrays.fill(upper, 0, rows, Double.POSITIVE_INFINITY);
    }

    private void resize(int rows) {
        firstJacobian = new double[6 * rows];
        secondJacobian = new double[6 * rows];
        firstResponse = new double[6 * rows];
        secondResponse = new double[6 * rows];
        rightHandSide = new double[rows];
        softness = new double[rows];
        lower = new double[rows];
        upper = new double[rows];
        force = new double[rows];
        state = new byte[rows];
        nextState = new byte[rows];
        solution = new double[rows];
    }

    static void setLinear(double[] jacobian, int row, double x, double y, double z) {
        Rotations.set(jacobian, 6 * row, x, y, z);
    }

    static void setAngular(double[] jacobian, int row, double x, double y, double z) {
        Rotations.set(jacobian, 6 * row + 3, x, y, z);
    }

    /** Computes the right-hand side and M⁻¹ Jᵀ of a joint's rows. The bodies must be prepared. */
    void prepare(ConstraintJoint joint, double rate) {
        Body one = joint.first;
        Body two = joint.second;
        int from = joint.firstRow;
        int to = from + joint.rowCount();
        if (joint.hinge && two != null) {
            applyInverseMassToHinge(one, firstJacobian, firstResponse, from);
            applyInverseMassToHinge(two, secondJacobian, secondResponse, from);
            rightHandSideOfHinge(from, one.unconstrained, two.unconstrained, rate);
        } else {
            applyInverseMass(one, firstJacobian, firstResponse, from, to);
            if (two != null) {
                applyInverseMass(two, secondJacobian, secondResponse, from, to);
            }
            for (int row = from; row < to; row++) {
                double free = dot6(firstJacobian, 6 * row, one.unconstrained, 0);
                if (two != null) {
                    free += dot6(secondJacobian, 6 * row, two.unconstrained, 0);
                }
                rightHandSide[row] = rightHandSide[row] * rate - free;
            }
        }
        for (int row = from; row < to; row++) {
            softness[row] *= rate;
        }
    }

    private void rightHandSideOfHinge(int row, double[] one, double[] two, double rate) {
        int at = 6 * row;
        double along = firstJacobian[at];
        for (int axis = 0; axis < 3; axis++) {
            int angular = at + 6 * axis + 3;
            double free = along * one[axis] + Rotations.dot(firstJacobian, angular, one, 3);
            free += -along * two[axis] + Rotations.dot(secondJacobian, angular, two, 3);
            rightHandSide[row + axis] = rightHandSide[row + axis] * rate - free;
        }
        for (int axis = 3; axis < 6; axis++) {
            int angular = at + 6 * axis + 3;
            double free =
                    Rotations.dot(firstJacobian, angular, one, 3) + Rotations.dot(secondJacobian, angular, two, 3);
            rightHandSide[row + axis] = rightHandSide[row + axis] * rate - free;
        }
    }

    private static void applyInverseMass(Body body, double[] jacobian, double[] response, int from, int to) {
        double mass = body.inverseMass;
        for (int at = 6 * from; at < 6 * to; at += 6) {
            response[at] = jacobian[at] * mass;
            response[at + 1] = jacobian[at + 1] * mass;
            response[at + 2] = jacobian[at + 2] * mass;
        }
        applyInverseInertia(body.inverseInertia, jacobian, response, 6 * from, 6 * to);
    }

    /**
     * Applies the inverse mass to the rows of a hinge: each of the first three has a linear part along one world axis,
     * the others have none.
     */
    private static void applyInverseMassToHinge(Body body, double[] jacobian, double[] response, int row) {
        int at = 6 * row;
        double move = jacobian[at] * body.inverseMass;
        setLinear(response, row, move, 0, 0);
        setLinear(response, row + 1, 0, move, 0);
        setLinear(response, row + 2, 0, 0, move);
        setLinear(response, row + 3, 0, 0, 0);
        setLinear(response, row + 4, 0, 0, 0);
        setLinear(response, row + 5, 0, 0, 0);
        applyInverseInertia(body.inverseInertia, jacobian, response, at, at + 36);
    }

    private static void applyInverseInertia(double[] inverse, double[] jacobian, double[] response, int from, int to) {
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

    static double dot6(double[] jacobian, int at, double[] motions, int from) {
        return Rotations.dot(jacobian, at, motions, from) + Rotations.dot(jacobian, at + 3, motions, from + 3);
    }
}
