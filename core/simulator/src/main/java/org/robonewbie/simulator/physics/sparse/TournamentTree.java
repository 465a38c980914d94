package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/**
 * Tournament tree: finds the minimum of n keys, with O(log n) updates; among equal keys, the one with the smallest index.
 */
final class TournamentTree {

    private static final long REMOVED = Long.MAX_VALUE;

    /** Binary heap layout: the children of node i are 2i and 2i + 1, and each node holds the smaller of them. */
    private long[] nodes = {};
    /** Index of the first leaf. */
    private int leaves = 1;

    /** Removes all keys. */
    void reset(int size) {
        leaves = Integer.highestOneBit(Math.max(1, 2 * size - 1));
        if (nodes.length < 2 * leaves) {
            nodes = new long[2 * leaves];
        }
        Arrays.fill(nodes, leaves, 2 * leaves, REMOVED);
    }

    /** Sets a key; call {@link #build} afterwards. */
    void add(int index, int key) {
        nodes[leaves + index] = entry(index, key);
    }

    /** Builds the tree from its leaves. */
    void build() {
        for (int node = leaves - 1; node > 0; node--) {
            nodes[node] = Math.min(nodes[2 * node], nodes[2 * node + 1]);
        }
    }

    void update(int index, int key) {
        set(leaves + index, entry(index, key));
    }

    void remove(int index) {
        set(leaves + index, REMOVED);
    }

    /** Returns the index of the smallest key; the tree must not be empty. */
    int minimum() {
        return (int) nodes[1];
    }

    private static long entry(int index, int key) {
        return (long) key << Integer.SIZE | index;
    }

    private void set(int leaf, long entry) {
        nodes[leaf] = entry;
        for (int node = leaf / 2; node > 0; node /= 2) {
            long less = Math.min(nodes[2 * node], nodes[2 * node + 1]);
            if (nodes[node] == less) {
                return;
            }
            nodes[node] = less;
        }
    }
}
