package org.robonewbie.simulator.physics.sparse;

import org.jspecify.annotations.Nullable;

/** Whatever holds two bodies, or a body and what never moves: a hinge or a place where they touch. */
abstract class ConstraintJoint {

    /** How far its rows with limits are apart. */
    static final int ROWS_PER_LIMIT = 3;

    private static final int LIMIT_OF_HINGE = 5;

    /** The body that moves along the rows' Jacobians. */
    Body first;
    /** The body against which it is held; none for ground and walls. */
    @Nullable
    Body second;
    /** Where the joint's rows begin in the island's rows, while the island is stepped. */
    int firstRow;
    /** Whether this step has put the joint in an island already. */
    boolean visited;
    /** Whether its rows are those of a hinge: three along the axes of the world that hold a point, and three that only turn. */
    final boolean hinge;

    ConstraintJoint(Body first, @Nullable Body second, boolean hinge) {
        this.first = first;
        this.second = second;
        this.hinge = hinge;
    }

    /** Adds this joint to its bodies. */
    final void attach() {
        first.joints.add(this);
        if (second != null) {
            second.joints.add(this);
        }
    }

    /** The number of rows that the joint needs in this step, a multiple of three as {@link BlockKernels} wants it. */
    abstract int rowCount();

    /** The first of its rows that may have limits; {@link #ROWS_PER_LIMIT} further comes the next one. */
    final int firstLimit() {
        return hinge ? LIMIT_OF_HINGE : 0;
    }

    /**
     * Writes Jacobians, speeds, softness and limits.
     *
     * @param rows the island's rows, cleared
     * @param rate steps per second, 1/h
     */
    abstract void writeRows(ConstraintRows rows, double rate);

    /** Sets the states with which the solver begins, where something better is known than that all rows are free. */
    void setInitialBasis(ConstraintRows rows) {}

    /** Takes from the rows what has to be remembered after the step. */
    void readForces(ConstraintRows rows) {}

    /** The body at the other end of the joint. */
    final @Nullable Body opposite(Body body) {
        return body == first ? second : first;
    }
}
