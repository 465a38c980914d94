package org.robonewbie.simulator.physics.sparse;

import org.jspecify.annotations.Nullable;

/** Constraint between two bodies, or between a body and the static environment: a hinge or a contact. */
abstract class ConstraintJoint {

    /** Distance between consecutive bounded rows of a joint. */
    static final int BOUNDED_ROW_STRIDE = 3;

    private static final int BOUNDED_ROW_OF_HINGE = 5;

    Body first;
    /** Null if the first body is constrained relative to the ground or a wall. */
    @Nullable
    Body second;
    /** Index of the joint's first row in the island, valid during the step. */
    int firstRow;
    /** Whether the joint has already been added to an island in this step. */
    boolean visited;
    /** Whether the rows are those of a hinge: three that constrain a point along the world axes, and three that are angular. */
    final boolean hinge;

    ConstraintJoint(Body first, @Nullable Body second, boolean hinge) {
        this.first = first;
        this.second = second;
        this.hinge = hinge;
    }

    final void attach() {
        first.joints.add(this);
        if (second != null) {
            second.joints.add(this);
        }
    }

    /** Returns the number of rows in this step, a multiple of three as {@link BlockKernels} requires. */
    abstract int rowCount();

    /**
     * Returns the index, within the joint, of the first row that can have limits; the others follow at {@link
     * #BOUNDED_ROW_STRIDE}.
     */
    final int firstBoundedRow() {
        return hinge ? BOUNDED_ROW_OF_HINGE : 0;
    }

    /**
     * Writes Jacobians, target speeds, softness and limits.
     *
     * @param rows the island's rows, with default values
     * @param rate steps per second, 1/h
     */
    abstract void writeRows(ConstraintRows rows, double rate);

    /** Sets the initial state of each row that, based on the previous step, is not expected to be free. */
    void setInitialBasis(ConstraintRows rows) {}

    /** Reads forces and states from the solved rows. */
    void readForces(ConstraintRows rows) {}

    final @Nullable Body opposite(Body body) {
        return body == first ? second : first;
    }
}
