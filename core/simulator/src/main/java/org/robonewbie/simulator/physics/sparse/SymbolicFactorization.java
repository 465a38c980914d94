package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * Symbolic block Cholesky factorization of an island: the elimination order, the sparsity pattern of the factor and the
 * storage offsets of its blocks.
 *
 * <p>Joints are numbered by elimination order. Column k of the factor has a diagonal block and, below it, one block for
 * each later joint that is coupled with k. The size of a block is given by the row counts of its two joints. The
 * factorization depends only on which joints connect which bodies, so it is valid as long as the contact pattern stays
 * the same, and for every robot of the same type.
 *
 * <p>A pile of robots needs a new factorization in nearly every step. An unused object can therefore be recomputed for
 * another island, reusing its arrays, which may be longer than necessary.
 */
final class SymbolicFactorization {

    /** Number of integers that describe an update: source column, left block, right block, target block, target rows. */
    static final int INTS_PER_UPDATE = 5;

    /** Number of integers that describe an overlap: column, its side, row, its side, offset of the block. */
    static final int INTS_PER_OVERLAP = 5;

    /** Island index of each joint in elimination order. */
    int[] order = {};
    /** First row of each joint, followed by the total number of rows. */
    int[] firstRow = {0};
    /** Start of each column in {@link #below}, followed by the total length. */
    int[] belowStart = {0};
    /** Row indices of the blocks below the diagonal, column by column, ascending within a column. */
    int[] below = {};
    /** Storage offset of each block in {@link #below}. */
    int[] belowOffset = {};
    /**
     * Storage offset of each diagonal block, which is followed by the column's other blocks. The final entry is the total
     * storage size.
     */
    int[] diagonalOffset = {0};
    /** Start of each column in {@link #updates}, followed by the total length. */
    int[] updatesStart = {0};
    /** Products of earlier blocks that are subtracted from each column. */
    int[] updates = {};
    /** Pairs of joints that share a body; the side is 0 for a joint's first body and 1 for its second. */
    int[] overlaps = {};
    /** Number of valid elements of {@link #overlaps}. */
    int overlapsEnd;

    private final IntegerList coupled = new IntegerList();
    private int joints;
    private int[] key = {};
    private int keyLength;
    /** Elimination index of each joint of the island; the inverse of {@link #order}. */
    private int[] position = {};

    /**
     * Computes the factorization of an island.
     *
     * @param newKey {@link CouplingGraph#INTS_PER_JOINT} integers per joint
     * @param length number of integers
     * @param bodies number of bodies of the island
     * @param graph scratch graph for the elimination order
     */
    void compute(int[] newKey, int length, int bodies, CouplingGraph graph) {
        graph.build(newKey, length, bodies);
        ensureCapacity(graph.size(), length);
        System.arraycopy(newKey, 0, key, 0, length);
        graph.eliminate(order, coupled, belowStart);
        below = coupled.elements;
        numberJoints(graph);
        layOutBlocks();
        scheduleUpdates();
        listOverlaps(graph);
    }

    private void ensureCapacity(int newJoints, int length) {
        joints = newJoints;
        keyLength = length;
        if (order.length < joints) {
            int room = joints + joints / 4;
            order = new int[room];
            position = new int[room];
            firstRow = new int[room + 1];
            belowStart = new int[room + 1];
            diagonalOffset = new int[room + 1];
            updatesStart = new int[room + 1];
            key = new int[CouplingGraph.INTS_PER_JOINT * room];
        }
    }

    /** Returns whether this factorization is for the same joints between the same bodies. */
    boolean matches(int[] otherKey, int length) {
        return Arrays.equals(key, 0, keyLength, otherKey, 0, length);
    }

    int memoryInInts() {
        return key.length + 6 * order.length + 2 * coupled.elements.length + updates.length + overlaps.length;
    }

    /**
     * Returns whether the arrays are long enough for the given number of joints, but at most twice as long as needed.
     */
    boolean hasRoomFor(int otherJoints) {
        return otherJoints <= order.length && order.length <= 2 * otherJoints;
    }

    int joints() {
        return joints;
    }

    int rows() {
        return firstRow[joints];
    }

    int rows(int joint) {
        return firstRow[joint + 1] - firstRow[joint];
    }

    /** Returns the storage size of all blocks. */
    int size() {
        return diagonalOffset[joints];
    }

    private void numberJoints(CouplingGraph graph) {
        firstRow[0] = 0;
        for (int k = 0; k < joints; k++) {
            position[order[k]] = k;
            firstRow[k + 1] = firstRow[k] + graph.rows(order[k]);
        }
        for (int i = 0; i < belowStart[joints]; i++) {
            below[i] = position[below[i]];
        }
        for (int k = 0; k < joints; k++) {
            Arrays.sort(below, belowStart[k], belowStart[k + 1]);
        }
    }

    private void layOutBlocks() {
        if (belowOffset.length < below.length) {
            belowOffset = new int[below.length];
        }
        int next = 0;
        for (int k = 0; k < joints; k++) {
            diagonalOffset[k] = next;
            int width = rows(k);
            next += width * width;
            for (int i = belowStart[k]; i < belowStart[k + 1]; i++) {
                belowOffset[i] = next;
                next += width * rows(below[i]);
            }
        }
        diagonalOffset[joints] = next;
    }

    private void scheduleUpdates() {
        countUpdates();
        for (int source = 0; source < joints; source++) {
            int end = belowStart[source + 1];
            for (int right = belowStart[source]; right < end; right++) {
                scheduleUpdates(source, right, end);
            }
        }
        System.arraycopy(updatesStart, 0, updatesStart, 1, joints);
        updatesStart[0] = 0;
    }

    /** Sets {@code updatesStart} to the start of each column; scheduling an update advances it. */
    private void countUpdates() {
        Arrays.fill(updatesStart, 0, joints + 1, 0);
        for (int source = 0; source < joints; source++) {
            int end = belowStart[source + 1];
            for (int right = belowStart[source]; right < end; right++) {
                updatesStart[below[right]] += INTS_PER_UPDATE * (end - right);
            }
        }
        int next = 0;
        for (int k = 0; k < joints; k++) {
            int count = updatesStart[k];
            updatesStart[k] = next;
            next += count;
        }
        if (updates.length < next) {
            updates = new int[next + next / 4];
        }
    }

    /**
     * Schedules the updates of one column: the products of a block {@code right} of the source column with itself and with each
     * block below it.
     */
    private void scheduleUpdates(int source, int right, int end) {
        int column = below[right];
        int at = updatesStart[column];
        int search = belowStart[column];
        for (int left = right; left < end; left++) {
            int row = below[left];
            while (row != column && below[search] != row) {
                search++;
            }
            updates[at] = source;
            updates[at + 1] = belowOffset[left];
            updates[at + 2] = belowOffset[right];
            updates[at + 3] = row == column ? diagonalOffset[column] : belowOffset[search];
            updates[at + 4] = rows(row);
            at += INTS_PER_UPDATE;
        }
        updatesStart[column] = at;
    }

    private void listOverlaps(CouplingGraph graph) {
        int maxOverlaps = 0;
        for (int body = 0; body < graph.bodies(); body++) {
            int ends = graph.firstEnd(body + 1) - graph.firstEnd(body);
            maxOverlaps += ends * ends;
        }
        if (overlaps.length < INTS_PER_OVERLAP * maxOverlaps) {
            overlaps = new int[INTS_PER_OVERLAP * (maxOverlaps + maxOverlaps / 4)];
        }
        overlapsEnd = 0;
        for (int body = 0; body < graph.bodies(); body++) {
            for (int i = graph.firstEnd(body); i < graph.firstEnd(body + 1); i++) {
                for (int j = graph.firstEnd(body); j < graph.firstEnd(body + 1); j++) {
                    addOverlap(graph.end(i), graph.end(j));
                }
            }
        }
    }

    private void addOverlap(int one, int other) {
        int column = position[one / 2];
        int row = position[other / 2];
        if (column <= row) {
            overlaps[overlapsEnd] = column;
            overlaps[overlapsEnd + 1] = one % 2;
            overlaps[overlapsEnd + 2] = row;
            overlaps[overlapsEnd + 3] = other % 2;
            overlaps[overlapsEnd + 4] = offset(row, column);
            overlapsEnd += INTS_PER_OVERLAP;
        }
    }

    private int offset(int row, int column) {
        if (row == column) {
            return diagonalOffset[column];
        }
        return belowOffset[Arrays.binarySearch(below, belowStart[column], belowStart[column + 1], row)];
    }
}
