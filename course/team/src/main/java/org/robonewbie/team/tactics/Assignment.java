package org.robonewbie.team.tactics;

import java.util.Arrays;

/**
 * Gives each player a place so that all costs together are as small as possible: the Hungarian method.
 *
 * <p>To give each player the place that is nearest to it does not work, since two may want the same one, and to let them choose one
 * after the other leaves the last one a long way. With n players there are n! possibilities, for ten more than three million. The
 * method finds the best with about n³ steps: it puts one player after the other in, and lets those that are in already move on to
 * other places where that is cheaper for all.
 *
 * <p>Source: H. W. Kuhn, <em>The Hungarian method for the assignment problem</em>, 1955, in the form with potentials.
 */
public final class Assignment {

    private final double[][] cost;
    private final int players;
    private final int places;
    private final double[] playerPotential;
    private final double[] placePotential;
    /** The player of each place, counted from 1; 0 is none. Index 0 stands for the player that is put in. */
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
     * Finds the best places.
     *
     * @param cost what each place costs each player, at least as many places as players
     * @return for each player the index of its place
     */
    public static int[] cheapest(double[][] cost) {
        Assignment assignment = new Assignment(cost);
        for (int player = 1; player <= assignment.players; player++) {
            assignment.putIn(player);
        }
        return assignment.result();
    }

    private void putIn(int player) {
        playerOf[0] = player;
        double[] least = new double[places + 1];
        Arrays.fill(least, Double.POSITIVE_INFINITY);
        boolean[] used = new boolean[places + 1];
        int place = 0;
        do {
            used[place] = true;
            place = nextPlace(place, least, used);
        } while (playerOf[place] != 0);
        moveOn(place);
    }

    /** Finds the place that can be reached next at the least cost, and pays that cost. */
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
        pay(step, least, used);
        return next;
    }

    private void pay(double step, double[] least, boolean... used) {
        for (int place = 0; place <= places; place++) {
            if (used[place]) {
                playerPotential[playerOf[place]] += step;
                placePotential[place] -= step;
            } else {
                least[place] -= step;
            }
        }
    }

    /** Lets all players along the way move on by one place, so that the free one at its end is filled. */
    private void moveOn(int free) {
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
