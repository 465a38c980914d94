package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;
import java.util.List;

/**
 * Accelerations M⁻¹ Jᵀ λ of the selected bodies, caused by the constraint forces of an island.
 *
 * <p>The LCP solver needs them twice per iteration, so the data is kept in contiguous arrays instead of in objects
 * scattered in memory. Contributions are summed in the order of the island's joints. Joints and bodies are identified by
 * their island index.
 */
final class Accelerations {

    private static final int DIMENSIONS = 6;

    private final ConstraintRows rows;
    private final ScratchCapacity jointCapacity = new ScratchCapacity(1 << 7);
    private final ScratchCapacity bodyCapacity = new ScratchCapacity(1 << 7);
    private int joints;
    private int bodies;
    private int[] first = {};
    /** The second body of each joint, or {@link CouplingGraph#FIXED}. */
    private int[] second = {};

    private int[] firstRow = {};

    private int[] endRow = {};
    private int[] firstBoundedRow = {};
    private boolean[] hinge = {};
    /** Whether each joint has a row with a nonzero force at its limit. */
    private boolean[] pushing = {};

    private boolean[] selected = {};
    /** Linear and angular acceleration of each body. */
    private double[] sums = {};

    Accelerations(ConstraintRows rows) {
        this.rows = rows;
    }

    void begin(List<ConstraintJoint> islandJoints, int bodyCount) {
        joints = islandJoints.size();
        bodies = bodyCount;
        ensureCapacity();
        for (int i = 0; i < joints; i++) {
            ConstraintJoint joint = islandJoints.get(i);
            first[i] = joint.first.islandIndex;
            second[i] = joint.second == null ? CouplingGraph.FIXED : joint.second.islandIndex;
            firstRow[i] = joint.firstRow;
            endRow[i] = joint.firstRow + joint.rowCount();
            firstBoundedRow[i] = joint.firstRow + joint.firstBoundedRow();
            hinge[i] = joint.hinge;
        }
    }

    private void ensureCapacity() {
        int length = jointCapacity.fit(first.length, joints);
        if (length != first.length) {
            first = new int[length];
            second = new int[length];
            firstRow = new int[length];
            endRow = new int[length];
            firstBoundedRow = new int[length];
            hinge = new boolean[length];
            pushing = new boolean[length];
        }
        int room = bodyCapacity.fit(selected.length, bodies);
        if (room != selected.length) {
            selected = new boolean[room];
            sums = new double[DIMENSIONS * room];
        }
    }

    void selectAll(boolean select) {
        Arrays.fill(selected, 0, bodies, select);
    }

    void select(int joint) {
        selected[first[joint]] = true;
        if (second[joint] != CouplingGraph.FIXED) {
            selected[second[joint]] = true;
        }
    }

    boolean isSelected(int joint) {
        return selected[first[joint]] || (second[joint] != CouplingGraph.FIXED && selected[second[joint]]);
    }

    void clearPushing() {
        Arrays.fill(pushing, 0, joints, false);
    }

    /** Marks a joint as having a nonzero force at a limit and selects its bodies. */
    void markPushing(int joint) {
        pushing[joint] = true;
        select(joint);
    }

    /** Computes the accelerations due to forces at their limits; all other forces are still zero. */
    void sumPushing() {
        Arrays.fill(sums, 0, DIMENSIONS * bodies, 0);
        for (int i = 0; i < joints; i++) {
            if (pushing[i]) {
                for (int row = firstBoundedRow[i]; row < endRow[i]; row += ConstraintJoint.BOUNDED_ROW_STRIDE) {
                    addRow(i, row);
                }
            }
        }
    }

    private void addRow(int joint, int row) {
        if (rows.force[row] != 0) {
            addHalf(rows.firstResponse, row, row + 1, DIMENSIONS * first[joint], 0);
            addHalf(rows.firstResponse, row, row + 1, DIMENSIONS * first[joint], 3);
            if (second[joint] != CouplingGraph.FIXED) {
                addHalf(rows.secondResponse, row, row + 1, DIMENSIONS * second[joint], 0);
                addHalf(rows.secondResponse, row, row + 1, DIMENSIONS * second[joint], 3);
            }
        }
    }

    /** Computes the accelerations of the selected bodies due to all forces. */
    void sumAll() {
        Arrays.fill(sums, 0, DIMENSIONS * bodies, 0);
        for (int i = 0; i < joints; i++) {
            if (selected[first[i]]) {
                add(rows.firstResponse, i, DIMENSIONS * first[i]);
            }
            if (second[i] != CouplingGraph.FIXED && selected[second[i]]) {
                add(rows.secondResponse, i, DIMENSIONS * second[i]);
            }
        }
    }

    private void add(double[] response, int joint, int body) {
        int from = firstRow[joint];
        if (hinge[joint]) {
            int at = DIMENSIONS * from;
            sums[body] += response[at] * rows.force[from];
            sums[body + 1] += response[at + 7] * rows.force[from + 1];
            sums[body + 2] += response[at + 14] * rows.force[from + 2];
        } else {
            addHalf(response, from, endRow[joint], body, 0);
        }
        addHalf(response, from, endRow[joint], body, 3);
    }

    /**
     * Adds the effect of a joint's rows to the linear (half = 0) or angular (half = 3) part of a body's acceleration.
     */
    private void addHalf(double[] response, int from, int end, int body, int half) {
        int to = body + half;
        double x = sums[to];
        double y = sums[to + 1];
        double z = sums[to + 2];
        for (int row = from; row < end; row++) {
            int at = DIMENSIONS * row + half;
            double factor = rows.force[row];
            x += response[at] * factor;
            y += response[at + 1] * factor;
            z += response[at + 2] * factor;
        }
        sums[to] = x;
        sums[to + 1] = y;
        sums[to + 2] = z;
    }

    /** Returns the residual A λ - b of a row, based on the most recently computed accelerations. */
    double residual(int joint, int row) {
        double motion = ConstraintRows.dot6(rows.firstJacobian, DIMENSIONS * row, sums, DIMENSIONS * first[joint]);
        if (second[joint] != CouplingGraph.FIXED) {
            motion += ConstraintRows.dot6(rows.secondJacobian, DIMENSIONS * row, sums, DIMENSIONS * second[joint]);
        }
        return motion + rows.softness[row] * rows.force[row] - rows.rightHandSide[row];
    }

    void writeTo(List<Body> islandBodies) {
        for (int i = 0; i < bodies; i++) {
            System.arraycopy(sums, DIMENSIONS * i, islandBodies.get(i).acceleration, 0, DIMENSIONS);
        }
    }
}
