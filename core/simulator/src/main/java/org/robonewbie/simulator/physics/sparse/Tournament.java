package org.robonewbie.simulator.physics.sparse;

import java.util.Arrays;

/** Knows at any time who of many has the least number, of equals the first, though the numbers change one by one. */
final class Tournament {

    private static final long GONE = Long.MAX_VALUE;

    /** A binary tree: the children of i are 2i and 2i + 1, and each node holds the less of its children. */
    private long[] nodes = {};
    /** Where the leaves begin. */
    private int leaves = 1;

    /** Clears the list of players. */
    void begin(int players) {
        leaves = Integer.highestOneBit(Math.max(1, 2 * players - 1));
        if (nodes.length < 2 * leaves) {
            nodes = new long[2 * leaves];
        }
        Arrays.fill(nodes, leaves, 2 * leaves, GONE);
    }

    /** Enters a player before the first match. */
    void enter(int player, int number) {
        nodes[leaves + player] = entry(player, number);
    }

    /** Plays all matches. */
    void play() {
        for (int node = leaves - 1; node > 0; node--) {
            nodes[node] = Math.min(nodes[2 * node], nodes[2 * node + 1]);
        }
    }

    /** Changes a player's number. */
    void change(int player, int number) {
        set(leaves + player, entry(player, number));
    }

    /** Takes a player out. */
    void leave(int player) {
        set(leaves + player, GONE);
    }

    /** Who has the least number; there must be one left. */
    int winner() {
        return (int) nodes[1];
    }

    private static long entry(int player, int number) {
        return (long) number << Integer.SIZE | player;
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
