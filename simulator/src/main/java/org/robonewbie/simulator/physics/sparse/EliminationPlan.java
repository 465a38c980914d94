package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * In which order the joints of an island are eliminated, which blocks of the factor that fills, and where each block is
 * kept.
 *
 * <p>From here on joints are numbered by their place in that order. Column k of the factor has a diagonal block and below
 * it a block for each later joint that is coupled with k; a block is as wide and high as its joints have rows. A plan
 * depends on nothing but which joints hold which bodies, so it serves as long as the same limbs touch the same things,
 * and for every robot of the kind.
 */
final class EliminationPlan {

    /** How many numbers describe an update: source column, left factor, right factor, target, rows of the target. */
    static final int UPDATE_NUMBERS = 5;

    /** How many numbers describe an overlap: column, its side, row, its side, offset of the block. */
    static final int OVERLAP_NUMBERS = 5;

    /** The plan of an island without joints. */
    static final EliminationPlan EMPTY = new EliminationPlan(new int[0], 0);

    /** Which joint of the island comes at each place. */
    final int[] order;
    /** Where each joint's rows begin; one more entry for the end. */
    final int[] firstRow;
    /** For each column, the later joints that have a block in it, in ascending order. */
    final int[][] below;
    /** For each column, where those blocks begin. */
    final int[][] belowOffset;
    /** For each column, where its diagonal block begins. */
    final int[] diagonalOffset;
    /** For each column, the products of earlier blocks that are taken from it. */
    final int[][] updates;
    /** Where joints meet on a body; the side is 0 for a joint's first body and 1 for its second. */
    final int[] overlaps;
    /** How many numbers all blocks have together. */
    final int size;

    private final int[] key;
    private final int numbers;

    /**
     * Creates a plan.
     *
     * @param key {@link CouplingGraph#NUMBERS_PER_JOINT} numbers for each joint
     * @param bodies the number of bodies of the island
     */
    EliminationPlan(int[] key, int bodies) {
        this.key = key;
        CouplingGraph graph = new CouplingGraph(key, bodies);
        int joints = graph.size();
        order = new int[joints];
        below = graph.eliminate(order);
        int[] place = placeJoints(graph);
        firstRow = new int[joints + 1];
        for (int k = 0; k < joints; k++) {
            firstRow[k + 1] = firstRow[k] + graph.rows(order[k]);
        }
        diagonalOffset = new int[joints];
        belowOffset = new int[joints][];
        size = placeBlocks();
        updates = planUpdates();
        overlaps = planOverlaps(graph, place);
        numbers = key.length + 4 * joints + overlaps.length + 2 * count(below) + count(updates);
    }

    private static int count(int[][] lists) {
        return Arrays.stream(lists).mapToInt(list -> list.length).sum();
    }

    /** Whether this plan was made for the same joints between the same bodies. */
    boolean suits(int[] joints, int length) {
        return Arrays.equals(key, 0, key.length, joints, 0, length);
    }

    /** The memory that the plan takes, in integers. */
    int numbers() {
        return numbers;
    }

    int joints() {
        return order.length;
    }

    int rows() {
        return firstRow[order.length];
    }

    int rows(int joint) {
        return firstRow[joint + 1] - firstRow[joint];
    }

    private int[] placeJoints(CouplingGraph graph) {
        int[] place = new int[graph.size()];
        for (int k = 0; k < order.length; k++) {
            place[order[k]] = k;
        }
        for (int[] joints : below) {
            Arrays.setAll(joints, i -> place[joints[i]]);
            Arrays.sort(joints);
        }
        return place;
    }

    private int placeBlocks() {
        int next = 0;
        for (int k = 0; k < order.length; k++) {
            diagonalOffset[k] = next;
            next += rows(k) * rows(k);
            belowOffset[k] = new int[below[k].length];
            for (int i = 0; i < below[k].length; i++) {
                belowOffset[k][i] = next;
                next += rows(k) * rows(below[k][i]);
            }
        }
        return next;
    }

    private int offset(int row, int column) {
        return row == column ? diagonalOffset[column] : belowOffset[column][Arrays.binarySearch(below[column], row)];
    }

    private int[][] planUpdates() {
        IntegerList[] lists = new IntegerList[order.length];
        Arrays.setAll(lists, k -> new IntegerList());
        for (int source = 0; source < order.length; source++) {
            for (int right = 0; right < below[source].length; right++) {
                int column = below[source][right];
                for (int left = right; left < below[source].length; left++) {
                    int row = below[source][left];
                    IntegerList list = lists[column];
                    list.add(source);
                    list.add(belowOffset[source][left]);
                    list.add(belowOffset[source][right]);
                    list.add(offset(row, column));
                    list.add(rows(row));
                }
            }
        }
        return Arrays.stream(lists).map(IntegerList::toArray).toArray(int[][]::new);
    }

    private int[] planOverlaps(CouplingGraph graph, int[] place) {
        IntegerList list = new IntegerList();
        for (int[] ends : graph.endsOnBody()) {
            for (int one : ends) {
                for (int other : ends) {
                    int column = place[one / 2];
                    int row = place[other / 2];
                    if (column <= row) {
                        list.add(column);
                        list.add(one % 2);
                        list.add(row);
                        list.add(other % 2);
                        list.add(offset(row, column));
                    }
                }
            }
        }
        return list.toArray();
    }
}
