package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * Which joints of an island share a body, and in which order they are best eliminated.
 *
 * <p>Eliminating a joint couples all its remaining neighbours with one another. Always taking the joint whose neighbours
 * have the fewest rows (minimum degree; of equals the first) starts at contacts with the ground, hands and feet and ends
 * in the torso; on a tree nothing is coupled then that was not before.
 */
final class CouplingGraph {

    /** Stands for the body that never moves. */
    static final int FIXED = -1;

    /** How many numbers describe a joint: first body, second body or {@link #FIXED}, rows. */
    static final int NUMBERS_PER_JOINT = 3;

    private final int[] joints;
    private final int size;
    private final int[][] endsOnBody;
    private final long[][] neighbours;
    private final int[] neighbourRows;

    /**
     * Builds the graph.
     *
     * @param joints {@link #NUMBERS_PER_JOINT} numbers for each joint
     * @param bodies how many bodies there are
     */
    CouplingGraph(int[] joints, int bodies) {
        this.joints = joints;
        this.size = joints.length / NUMBERS_PER_JOINT;
        this.endsOnBody = findEnds(bodies);
        this.neighbours = new long[size][(size + 63) / 64];
        this.neighbourRows = new int[size];
        couple();
    }

    /** The joints on each body, each as twice its number, plus one if the body is at its second end. */
    int[][] endsOnBody() {
        return endsOnBody;
    }

    int size() {
        return size;
    }

    int rows(int joint) {
        return joints[NUMBERS_PER_JOINT * joint + 2];
    }

    private int[][] findEnds(int bodies) {
        IntegerList[] lists = new IntegerList[bodies];
        Arrays.setAll(lists, body -> new IntegerList());
        for (int joint = 0; joint < size; joint++) {
            for (int side = 0; side < 2; side++) {
                int body = joints[NUMBERS_PER_JOINT * joint + side];
                if (body != FIXED) {
                    lists[body].add(2 * joint + side);
                }
            }
        }
        return Arrays.stream(lists).map(IntegerList::toArray).toArray(int[][]::new);
    }

    private void couple() {
        for (int[] ends : endsOnBody) {
            for (int one : ends) {
                for (int other : ends) {
                    if (one != other) {
                        add(neighbours[one / 2], other / 2);
                    }
                }
            }
        }
        for (int joint = 0; joint < size; joint++) {
            neighbourRows[joint] = rowsOf(neighbours[joint]);
        }
    }

    /**
     * Eliminates all joints.
     *
     * @param order receives the joints in the order in which they went
     * @return for each place in the order, the joints that were coupled with the one that went, unsorted
     */
    int[][] eliminate(int[] order) {
        int[][] coupled = new int[size][];
        boolean[] gone = new boolean[size];
        for (int place = 0; place < size; place++) {
            int joint = leastCoupled(gone);
            gone[joint] = true;
            order[place] = joint;
            coupled[place] = members(neighbours[joint]);
            for (int other : coupled[place]) {
                long[] set = neighbours[other];
                for (int word = 0; word < set.length; word++) {
                    set[word] |= neighbours[joint][word];
                }
                remove(set, other);
                remove(set, joint);
                neighbourRows[other] = rowsOf(set);
            }
        }
        return coupled;
    }

    private int leastCoupled(boolean[] gone) {
        int best = -1;
        for (int joint = 0; joint < size; joint++) {
            if (!gone[joint] && (best < 0 || neighbourRows[joint] < neighbourRows[best])) {
                best = joint;
            }
        }
        return best;
    }

    private int rowsOf(long[] set) {
        int sum = 0;
        for (int word = 0; word < set.length; word++) {
            for (long bits = set[word]; bits != 0; bits &= bits - 1) {
                sum += rows(64 * word + Long.numberOfTrailingZeros(bits));
            }
        }
        return sum;
    }

    private static int[] members(long[] set) {
        IntegerList list = new IntegerList();
        for (int word = 0; word < set.length; word++) {
            for (long bits = set[word]; bits != 0; bits &= bits - 1) {
                list.add(64 * word + Long.numberOfTrailingZeros(bits));
            }
        }
        return list.toArray();
    }

    private static void add(long[] set, int member) {
        set[member / 64] |= 1L << (member % 64);
    }

    private static void remove(long[] set, int member) {
        set[member / 64] &= ~(1L << (member % 64));
    }
}
