package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * Elimination graph of an island: two joints are neighbours if they share a body. It determines a minimum degree ordering for
 * the Cholesky factorization.
 *
 * <p>Eliminating a joint connects all its remaining neighbours (fill-in). The joint whose neighbours have the fewest rows
 * is eliminated first; among equals, the one with the smallest index. For a robot, the order therefore runs from ground
 * contacts, hands and feet to the torso, which causes no fill-in in a tree.
 *
 * <p>The arrays are reused for successive islands, because a pile of robots needs a new graph in nearly every step.
 */
final class CouplingGraph {

    /** Index of the static environment. */
    static final int FIXED = -1;

    /** Number of integers that describe a joint: first body, second body or {@link #FIXED}, row count. */
    static final int INTS_PER_JOINT = 3;

    private int size;
    private int bodies;
    /** Number of 64-bit words in a bit set of joints. */
    private int words;

    private int[] rows = {};
    /** Start of each body's entries in {@link #ends}, followed by the total number of entries. */
    private int[] endsStart = {};

    private int[] ends = {};
    /** Adjacency matrix, one bit set per joint. */
    private long[] neighbours = {};
    /** Total number of rows of each joint's neighbours. */
    private int[] degree = {};

    private final IntegerList members = new IntegerList();
    /** Indices of the bit set words that contain the {@link #members}. */
    private final IntegerList memberWords = new IntegerList();

    private final TournamentTree degrees = new TournamentTree();

    /**
     * Builds the graph.
     *
     * @param joints {@link #INTS_PER_JOINT} integers per joint
     * @param length number of integers
     * @param bodyCount number of bodies
     */
    void build(int[] joints, int length, int bodyCount) {
        size = length / INTS_PER_JOINT;
        bodies = bodyCount;
        words = (size + 63) / 64;
        ensureCapacity();
        for (int joint = 0; joint < size; joint++) {
            rows[joint] = joints[INTS_PER_JOINT * joint + 2];
        }
        groupEndsByBody(joints);
        connectNeighbours();
    }

    private void ensureCapacity() {
        if (rows.length < size) {
            rows = new int[size + size / 2];
            degree = new int[rows.length];
            ends = new int[2 * rows.length];
        }
        if (endsStart.length <= bodies + 1) {
            endsStart = new int[bodies + bodies / 2 + 2];
        }
        if (neighbours.length < size * words) {
            neighbours = new long[size * words * 3 / 2];
        }
    }

    int size() {
        return size;
    }

    int rows(int joint) {
        return rows[joint];
    }

    int bodies() {
        return bodies;
    }

    /** Returns the index of the first joint end at a body, for {@link #end}. The ends at the next body follow. */
    int firstEnd(int body) {
        return endsStart[body];
    }

    /** Returns the joint end at an index, encoded as twice the joint's index, plus one for the end at its second body. */
    int end(int index) {
        return ends[index];
    }

    /** Sorts the joint ends by body (counting sort). */
    private void groupEndsByBody(int[] joints) {
        Arrays.fill(endsStart, 0, bodies + 2, 0);
        for (int joint = 0; joint < size; joint++) {
            for (int side = 0; side < 2; side++) {
                endsStart[joints[INTS_PER_JOINT * joint + side] + 2]++;
            }
        }
        endsStart[1] = 0;
        for (int body = 0; body < bodies; body++) {
            endsStart[body + 2] += endsStart[body + 1];
        }
        for (int joint = 0; joint < size; joint++) {
            for (int side = 0; side < 2; side++) {
                int body = joints[INTS_PER_JOINT * joint + side];
                if (body != FIXED) {
                    ends[endsStart[body + 1]++] = 2 * joint + side;
                }
            }
        }
        endsStart[0] = 0;
    }

    private void connectNeighbours() {
        Arrays.fill(neighbours, 0, size * words, 0);
        for (int body = 0; body < bodies; body++) {
            for (int i = endsStart[body]; i < endsStart[body + 1]; i++) {
                for (int j = endsStart[body]; j < endsStart[body + 1]; j++) {
                    if (i != j) {
                        int other = ends[j] / 2;
                        neighbours[ends[i] / 2 * words + other / 64] |= 1L << (other % 64);
                    }
                }
            }
        }
        degrees.reset(size);
        for (int joint = 0; joint < size; joint++) {
            degree[joint] = rowsOfNeighbours(joint);
            degrees.add(joint, degree[joint]);
        }
        degrees.build();
    }

    /**
     * Eliminates all joints.
     *
     * @param order receives the joints in elimination order
     * @param coupled receives, for each eliminated joint, its remaining neighbours
     * @param coupledStart receives the start of each joint's neighbours in {@code coupled}, followed by the total number
     *     of entries
     */
    void eliminate(int[] order, IntegerList coupled, int[] coupledStart) {
        coupled.clear();
        for (int step = 0; step < size; step++) {
            int joint = degrees.minimum();
            degrees.remove(joint);
            order[step] = joint;
            coupledStart[step] = coupled.size();
            listNeighbours(joint * words);
            for (int i = 0; i < members.size(); i++) {
                int other = members.elements[i];
                coupled.add(other);
                addFill(other, joint);
                degrees.update(other, degree[other]);
            }
        }
        coupledStart[size] = coupled.size();
    }

    /** Connects a joint to all neighbours of the eliminated joint and disconnects it from that joint. */
    private void addFill(int other, int joint) {
        neighbours[other * words + joint / 64] &= ~(1L << (joint % 64));
        degree[other] -= rows[joint];
        for (int i = 0; i < memberWords.size(); i++) {
            int word = memberWords.elements[i];
            int at = other * words + word;
            long more = neighbours[joint * words + word] & ~neighbours[at];
            if (word == other / 64) {
                more &= ~(1L << (other % 64));
            }
            neighbours[at] |= more;
            degree[other] += rowsOf(word, more);
        }
    }

    private int rowsOfNeighbours(int joint) {
        int sum = 0;
        for (int word = 0; word < words; word++) {
            sum += rowsOf(word, neighbours[joint * words + word]);
        }
        return sum;
    }

    private int rowsOf(int word, long joints) {
        int sum = 0;
        for (long bits = joints; bits != 0; bits &= bits - 1) {
            sum += rows[64 * word + Long.numberOfTrailingZeros(bits)];
        }
        return sum;
    }

    private void listNeighbours(int set) {
        members.clear();
        memberWords.clear();
        for (int word = 0; word < words; word++) {
            if (neighbours[set + word] != 0) {
                memberWords.add(word);
            }
            for (long bits = neighbours[set + word]; bits != 0; bits &= bits - 1) {
                members.add(64 * word + Long.numberOfTrailingZeros(bits));
            }
        }
    }
}
