package org.robonewbie.team.tactics;

import java.util.Arrays;

/**
 * Assignment of players to positions with minimum total cost, by the Hungarian method.
 *
 * <p>Sending each player to its nearest position does not work, because two players may want the same one, and a greedy
 * choice for one player after another may leave a long path for the last one. With n players there are n! assignments: more
 * than three million for ten players. The method finds the best one in about n³ steps: it adds the players one by one, and
 * moves earlier players to other positions where that is cheaper in total.
 *
 * <p>Source: H. W. Kuhn, <em>The Hungarian method for the assignment problem</em>, 1955, in the form with potentials.
 */
public final class Assignment {

    private final double[][] cost;
    private final int players;
    private final int places;
    private final double[] playerPotential;
    private final double[] placePotential;
    /**
     * The player assigned to each position. Positions and players are numbered from 1; player 0 means none. Element 0 is
     * the player that is being added.
     */
    private final int[] playerOf;

    private final int[] cameFrom;

    private Assignment(double[][] cost) {
        this.cost = cost;
        players = cost.length;
        places = players == 0 ? 0 : cost[0].length;
        playerPotential = new double[players + 1];
        placePotential = new double[places + 1];
        playerOf = new int[places + 1];
        cameFrom = new int[places + 1];
    }

    /**
     * Computes an optimal assignment.
     *
     * @param cost cost of each position for each player, as {@code cost[player][position]}; there must be at least as
     *     many positions as players
     * @return for each player, the zero-based index of its position
     */
    public static int[] cheapest(double[][] cost) {
        Assignment assignment = new Assignment(cost);
        for (int player = 1; player <= assignment.players; player++) {
            assignment.add(player);
        }
        return assignment.result();
    }

    private void add(int player) {
        playerOf[0] = player;
        double[] least = new double[places + 1];
        Arrays.fill(least, Double.POSITIVE_INFINITY);
        boolean[] used = new boolean[places + 1];
        int place = 0;
        do {
            used[place] = true;
            place = nextPlace(place, least, used);
        } while (playerOf[place] != 0);
        augment(place);
    }

    /** Finds the next position on a shortest augmenting path and updates the potentials. */
    private int nextPlace(int place, double[] least, boolean... used) {
        int player = playerOf[place];
        int next = 0;
        double step = Double.POSITIVE_INFINITY;
        for (int other = 1; other <= places; other++) {
            if (!used[other]) {
                double reduced = cost[player - 1][other - 1] - playerPotential[player] - placePotential[other];
                if (reduced < least[other]) {
                    least[other] = reduced;
                    cameFrom[other] = place;
                }
                if (least[other] < step) {
                    step = least[other];
                    next = other;
                }
            }
        }
        updatePotentials(step, least, used);
        return next;
    }

    private void updatePotentials(double step, double[] least, boolean... used) {
        for (int place = 0; place <= places; place++) {
            if (used[place]) {
                playerPotential[playerOf[place]] += step;
                placePotential[place] -= step;
            } else {
                least[place] -= step;
            }
        }
    }

    /** Moves each player on the augmenting path to the next position on the path, ending at the free position. */
    private void augment(int free) {
        int place = free;
        while (place != 0) {
            int before = cameFrom[place];
            playerOf[place] = playerOf[before];
            place = before;
        }
    }

    private int[] result() {
        int[] placeOf = new int[players];
        for (int place = 1; place <= places; place++) {
            if (playerOf[place] != 0) {
                placeOf[playerOf[place] - 1] = place - 1;
            }
        }
        return placeOf;
    }
}
