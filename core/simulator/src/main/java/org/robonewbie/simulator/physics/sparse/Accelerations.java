package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;
import java.util.List;

/**
 * What the forces of an island's rows add to the accelerations of its bodies, M⁻¹ Jᵀ λ, for those bodies that are watched.
 *
 * <p>The solver needs it twice in each of its rounds. So all of it lies in a few arrays, and nothing goes over the objects of a pile, which
 * are scattered in memory. Each sum is made in the order of the island's joints. Joints have their numbers in the island here.
 */
final class Accelerations {

    private static final int NUMBERS = 6;

    private final ConstraintRows rows;
    private final ScratchCapacity jointCapacity = new ScratchCapacity(1 << 7);
    private final ScratchCapacity bodyCapacity = new ScratchCapacity(1 << 7);
    private int joints;
    private int bodies;
    private int[] first = {};
    /** The second body of each joint, or {@link CouplingGraph#FIXED}. */
    private int[] second = {};
    /** Where the joint's rows begin, where they end, and which of them may be the first with a limit. */
    private int[] firstRow = {};

    private int[] endRow = {};
    private int[] firstLimit = {};
    private boolean[] hinge = {};
    /** Whether a row of the joint pushes at its limit. */
    private boolean[] pushes = {};

    private boolean[] watched = {};
    /** Six numbers of each body. */
    private double[] numbers = {};

    Accelerations(ConstraintRows rows) {
        this.rows = rows;
    }

    /** Takes on an island, whose joints know their rows. */
    void begin(List<ConstraintJoint> islandJoints, int bodyCount) {
        joints = islandJoints.size();
        bodies = bodyCount;
        makeRoom();
        for (int i = 0; i < joints; i++) {
            ConstraintJoint joint = islandJoints.get(i);
            first[i] = joint.first.islandIndex;
            second[i] = joint.second == null ? CouplingGraph.FIXED : joint.second.islandIndex;
            firstRow[i] = joint.firstRow;
            endRow[i] = joint.firstRow + joint.rowCount();
            firstLimit[i] = joint.firstRow + joint.firstLimit();
            hinge[i] = joint.hinge;
        }
    }

    private void makeRoom() {
        int length = jointCapacity.fit(first.length, joints);
        if (length != first.length) {
            first = new int[length];
            second = new int[length];
            firstRow = new int[length];
            endRow = new int[length];
            firstLimit = new int[length];
            hinge = new boolean[length];
            pushes = new boolean[length];
        }
        int room = bodyCapacity.fit(watched.length, bodies);
        if (room != watched.length) {
            watched = new boolean[room];
            numbers = new double[NUMBERS * room];
        }
    }

    /** Watches all bodies, or none. */
    void watchAll(boolean all) {
        Arrays.fill(watched, 0, bodies, all);
    }

    /** Watches the bodies of a joint. */
    void watch(int joint) {
        watched[first[joint]] = true;
        if (second[joint] != CouplingGraph.FIXED) {
            watched[second[joint]] = true;
        }
    }

    /** Whether a body of a joint is watched. */
    boolean isWatched(int joint) {
        return watched[first[joint]] || (second[joint] != CouplingGraph.FIXED && watched[second[joint]]);
    }

    /** Forgets which joints push. */
    void stopPushing() {
        Arrays.fill(pushes, 0, joints, false);
    }

    /** Notes that a row of a joint pushes at its limit, and watches its bodies. */
    void push(int joint) {
        pushes[joint] = true;
        watch(joint);
    }

    /** Sums up what all rows with limits do whose force is not zero; the others have none yet. */
    void addPushes() {
        Arrays.fill(numbers, 0, NUMBERS * bodies, 0);
        for (int i = 0; i < joints; i++) {
            if (pushes[i]) {
                for (int row = firstLimit[i]; row < endRow[i]; row += ConstraintJoint.ROWS_PER_LIMIT) {
                    addRow(i, row);
                }
            }
        }
    }

    private void addRow(int joint, int row) {
        if (rows.force[row] != 0) {
            addHalf(rows.firstResponse, row, row + 1, NUMBERS * first[joint], 0);
            addHalf(rows.firstResponse, row, row + 1, NUMBERS * first[joint], 3);
            if (second[joint] != CouplingGraph.FIXED) {
                addHalf(rows.secondResponse, row, row + 1, NUMBERS * second[joint], 0);
                addHalf(rows.secondResponse, row, row + 1, NUMBERS * second[joint], 3);
            }
        }
    }

    /** Sums up what all rows do. */
    void addAll() {
        Arrays.fill(numbers, 0, NUMBERS * bodies, 0);
        for (int i = 0; i < joints; i++) {
            if (watched[first[i]]) {
                add(rows.firstResponse, i, NUMBERS * first[i]);
            }
            if (second[i] != CouplingGraph.FIXED && watched[second[i]]) {
                add(rows.secondResponse, i, NUMBERS * second[i]);
            }
        }
    }

    private void add(double[] response, int joint, int body) {
        int from = firstRow[joint];
        if (hinge[joint]) {
            int at = NUMBERS * from;
            numbers[body] += response[at] * rows.force[from];
            numbers[body + 1] += response[at + 7] * rows.force[from + 1];
            numbers[body + 2] += response[at + 14] * rows.force[from + 2];
        } else {
            addHalf(response, from, endRow[joint], body, 0);
        }
        addHalf(response, from, endRow[joint], body, 3);
    }

    /** Adds the linear or the angular half. */
    private void addHalf(double[] response, int from, int end, int body, int half) {
        int to = body + half;
        double x = numbers[to];
        double y = numbers[to + 1];
        double z = numbers[to + 2];
        for (int row = from; row < end; row++) {
            int at = NUMBERS * row + half;
            double factor = rows.force[row];
            x += response[at] * factor;
            y += response[at + 1] * factor;
            z += response[at + 2] * factor;
        }
        numbers[to] = x;
        numbers[to + 1] = y;
        numbers[to + 2] = z;
    }

    /** The residual of a row: (A λ - b), with the accelerations that were summed up last. */
    double excess(int joint, int row) {
        double motion = ConstraintRows.dot6(rows.first, NUMBERS * row, numbers, NUMBERS * first[joint]);
        if (second[joint] != CouplingGraph.FIXED) {
            motion += ConstraintRows.dot6(rows.second, NUMBERS * row, numbers, NUMBERS * second[joint]);
        }
        return motion + rows.softness[row] * rows.force[row] - rows.wanted[row];
    }

    /** Gives the bodies their accelerations. */
    void tell(List<Body> islandBodies) {
        for (int i = 0; i < bodies; i++) {
            System.arraycopy(numbers, NUMBERS * i, islandBodies.get(i).acceleration, 0, NUMBERS);
        }
    }
}
