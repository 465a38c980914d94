package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * In which order the joints of an island are eliminated, which blocks of the factor that fills, and where each block is
 * kept.
 *
 * <p>From here on joints are numbered by their place in that order. Column k of the factor has a diagonal block and below
 * it a block for each later joint that is coupled with k; a block is as wide and high as its joints have rows. A factorization
 * depends on nothing but which joints hold which bodies, so it serves as long as the same limbs touch the same things,
 * and for every robot of the kind.
 *
 * <p>A pile of robots needs another factorization in nearly every step, so a factorization that is no longer needed can be replaced in the
 * same arrays, which may be longer than what they hold.
 */
final class SymbolicFactorization {

    /** How many numbers describe an update: source column, left factor, right factor, target, rows of the target. */
    static final int UPDATE_NUMBERS = 5;

    /** How many numbers describe an overlap: column, its side, row, its side, offset of the block. */
    static final int OVERLAP_NUMBERS = 5;

    /** Which joint of the island comes at each place. */
    int[] order = {};
    /** Where each joint's rows begin; one more entry for the end. */
    int[] firstRow = {0};
    /** For each column, where it begins in {@link #below}; one more entry for the end. */
    int[] belowStart = {0};
    /** For one column after the other, the later joints that have a block in it, in ascending order. */
    int[] below = {};
    /** Where those blocks begin. */
    int[] belowOffset = {};
    /** For each column, where its diagonal block begins, and all others of the column after it; one more entry for the end. */
    int[] diagonalOffset = {0};
    /** For each column, where it begins in {@link #updates}; one more entry for the end. */
    int[] updatesStart = {0};
    /** For one column after the other, the products of earlier blocks that are taken from it. */
    int[] updates = {};
    /** Where joints meet on a body; the side is 0 for a joint's first body and 1 for its second. */
    int[] overlaps = {};
    /** How many numbers of {@link #overlaps} count. */
    int overlapsEnd;

    private final IntegerList coupled = new IntegerList();
    private int joints;
    private int[] key = {};
    private int keyLength;
    /** The place of each joint in the order. */
    private int[] place = {};

    /** Creates the factorization of an island without joints. */
    SymbolicFactorization() {}

    /**
     * Makes the factorization of an island.
     *
     * @param newKey {@link CouplingGraph#NUMBERS_PER_JOINT} numbers for each joint
     * @param length how many numbers there are
     * @param bodies the number of bodies of the island
     * @param graph what finds the order
     */
    void make(int[] newKey, int length, int bodies, CouplingGraph graph) {
        graph.build(newKey, length, bodies);
        makeRoom(graph.size(), length);
        System.arraycopy(newKey, 0, key, 0, length);
        graph.eliminate(order, coupled, belowStart);
        below = coupled.numbers;
        placeJoints(graph);
        placeBlocks();
        planUpdates();
        planOverlaps(graph);
    }

    private void makeRoom(int newJoints, int length) {
        joints = newJoints;
        keyLength = length;
        if (order.length < joints) {
            int room = joints + joints / 4;
            order = new int[room];
            place = new int[room];
            firstRow = new int[room + 1];
            belowStart = new int[room + 1];
            diagonalOffset = new int[room + 1];
            updatesStart = new int[room + 1];
            key = new int[CouplingGraph.NUMBERS_PER_JOINT * room];
        }
    }

    /** Whether this factorization was made for the same joints between the same bodies. */
    boolean suits(int[] otherKey, int length) {
        return Arrays.equals(key, 0, keyLength, otherKey, 0, length);
    }

    /** The memory that the factorization takes, in integers. */
    int numbers() {
        return key.length + 6 * order.length + 2 * coupled.numbers.length + updates.length + overlaps.length;
    }

    /** Whether its arrays are worth being used for the factorization of so many joints: long enough, and not much too long. */
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

    /** How many numbers all blocks have together. */
    int size() {
        return diagonalOffset[joints];
    }

    private void placeJoints(CouplingGraph graph) {
        firstRow[0] = 0;
        for (int k = 0; k < joints; k++) {
            place[order[k]] = k;
            firstRow[k + 1] = firstRow[k] + graph.rows(order[k]);
        }
        for (int i = 0; i < belowStart[joints]; i++) {
            below[i] = place[below[i]];
        }
        for (int k = 0; k < joints; k++) {
            Arrays.sort(below, belowStart[k], belowStart[k + 1]);
        }
    }

    private void placeBlocks() {
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

    private void planUpdates() {
        countUpdates();
        for (int source = 0; source < joints; source++) {
            int end = belowStart[source + 1];
            for (int right = belowStart[source]; right < end; right++) {
                planUpdates(source, right, end);
            }
        }
        System.arraycopy(updatesStart, 0, updatesStart, 1, joints);
        updatesStart[0] = 0;
    }

    /** Lets the updates of each column begin at their place; it moves on with each update that is planned. */
    private void countUpdates() {
        Arrays.fill(updatesStart, 0, joints + 1, 0);
        for (int source = 0; source < joints; source++) {
            int end = belowStart[source + 1];
            for (int right = belowStart[source]; right < end; right++) {
                updatesStart[below[right]] += UPDATE_NUMBERS * (end - right);
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

    /** Plans what a source adds to the column of one of its blocks: its other blocks lie at later places there too. */
    private void planUpdates(int source, int right, int end) {
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
            at += UPDATE_NUMBERS;
        }
        updatesStart[column] = at;
    }

    private void planOverlaps(CouplingGraph graph) {
        int most = 0;
        for (int body = 0; body < graph.bodies(); body++) {
            int ends = graph.firstEnd(body + 1) - graph.firstEnd(body);
            most += ends * ends;
        }
        if (overlaps.length < OVERLAP_NUMBERS * most) {
            overlaps = new int[OVERLAP_NUMBERS * (most + most / 4)];
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
        int column = place[one / 2];
        int row = place[other / 2];
        if (column <= row) {
            overlaps[overlapsEnd] = column;
            overlaps[overlapsEnd + 1] = one % 2;
            overlaps[overlapsEnd + 2] = row;
            overlaps[overlapsEnd + 3] = other % 2;
            overlaps[overlapsEnd + 4] = offset(row, column);
            overlapsEnd += OVERLAP_NUMBERS;
        }
    }

    private int offset(int row, int column) {
        if (row == column) {
            return diagonalOffset[column];
        }
        return belowOffset[Arrays.binarySearch(below, belowStart[column], belowStart[column + 1], row)];
    }
}
