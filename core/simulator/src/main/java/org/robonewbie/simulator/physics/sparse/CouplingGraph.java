package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * Which joints of an island share a body, and in which order they are best eliminated.
 *
 * <p>Eliminating a joint couples all its remaining neighbours with one another. Always taking the joint whose neighbours
 * have the fewest rows (minimum degree; of equals the first) starts at contacts with the ground, hands and feet and ends
 * in the torso; on a tree nothing is coupled then that was not before.
 *
 * <p>One graph serves for one island after the other, since piles of robots need another one in nearly every step.
 */
final class CouplingGraph {

    /** Stands for the body that never moves. */
    static final int FIXED = -1;

    /** How many numbers describe a joint: first body, second body or {@link #FIXED}, rows. */
    static final int NUMBERS_PER_JOINT = 3;

    private int size;
    private int bodies;
    /** How many numbers hold a set of joints, a bit for each. */
    private int words;

    private int[] rows = {};
    /** Where the ends on each body begin; one more entry for the end. */
    private int[] endsStart = {};

    private int[] ends = {};
    private long[] neighbours = {};
    /** How many rows the neighbours of each joint have together. */
    private int[] rowsAround = {};

    private final IntegerList members = new IntegerList();
    /** Which words of a set of joints the members are in. */
    private final IntegerList memberWords = new IntegerList();

    private final TournamentTree fewestRows = new TournamentTree();

    /**
     * Builds the graph.
     *
     * @param joints {@link #NUMBERS_PER_JOINT} numbers for each joint
     * @param length how many numbers there are
     * @param bodyCount how many bodies there are
     */
    void build(int[] joints, int length, int bodyCount) {
        size = length / NUMBERS_PER_JOINT;
        bodies = bodyCount;
        words = (size + 63) / 64;
        makeRoom();
        for (int joint = 0; joint < size; joint++) {
            rows[joint] = joints[NUMBERS_PER_JOINT * joint + 2];
        }
        findEnds(joints);
        couple();
    }

    private void makeRoom() {
        if (rows.length < size) {
            rows = new int[size + size / 2];
            rowsAround = new int[rows.length];
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

    /** Where the ends of joints on a body begin in {@link #end}; those of the next body follow. */
    int firstEnd(int body) {
        return endsStart[body];
    }

    /** An end: twice the number of its joint, plus one if the body is at the joint's second end. */
    int end(int index) {
        return ends[index];
    }

    /** Counts the ends on each body, then puts each in the next free place of its body. */
    private void findEnds(int[] joints) {
        Arrays.fill(endsStart, 0, bodies + 2, 0);
        for (int joint = 0; joint < size; joint++) {
            for (int side = 0; side < 2; side++) {
                endsStart[joints[NUMBERS_PER_JOINT * joint + side] + 2]++;
            }
        }
        endsStart[1] = 0;
        for (int body = 0; body < bodies; body++) {
            endsStart[body + 2] += endsStart[body + 1];
        }
        for (int joint = 0; joint < size; joint++) {
            for (int side = 0; side < 2; side++) {
                int body = joints[NUMBERS_PER_JOINT * joint + side];
                if (body != FIXED) {
                    ends[endsStart[body + 1]++] = 2 * joint + side;
                }
            }
        }
        endsStart[0] = 0;
    }

    private void couple() {
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
        fewestRows.reset(size);
        for (int joint = 0; joint < size; joint++) {
            rowsAround[joint] = rowsOfNeighbours(joint);
            fewestRows.add(joint, rowsAround[joint]);
        }
        fewestRows.build();
    }

    /**
     * Eliminates all joints.
     *
     * @param order receives the joints in the order in which they went
     * @param coupled receives, for each place in the order, the joints that were coupled with the one that went
     * @param coupledStart receives where those of each place begin in {@code coupled}; one more entry for the end
     */
    void eliminate(int[] order, IntegerList coupled, int[] coupledStart) {
        coupled.clear();
        for (int place = 0; place < size; place++) {
            int joint = fewestRows.minimum();
            fewestRows.remove(joint);
            order[place] = joint;
            coupledStart[place] = coupled.size();
            findMembers(joint * words);
            for (int i = 0; i < members.size(); i++) {
                int other = members.numbers[i];
                coupled.add(other);
                join(other, joint);
                fewestRows.update(other, rowsAround[other]);
            }
        }
        coupledStart[size] = coupled.size();
    }

    /** Couples a joint with all neighbours of the one that goes, and no more with that one. On a tree it knows them all already. */
    private void join(int other, int joint) {
        neighbours[other * words + joint / 64] &= ~(1L << (joint % 64));
        rowsAround[other] -= rows[joint];
        for (int i = 0; i < memberWords.size(); i++) {
            int word = memberWords.numbers[i];
            int at = other * words + word;
            long more = neighbours[joint * words + word] & ~neighbours[at];
            if (word == other / 64) {
                more &= ~(1L << (other % 64));
            }
            neighbours[at] |= more;
            rowsAround[other] += rowsOf(word, more);
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

    private void findMembers(int set) {
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
