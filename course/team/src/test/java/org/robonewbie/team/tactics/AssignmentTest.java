package org.robonewbie.team.tactics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class AssignmentTest {

    @Test
    void givesAwayWhatIsNearestIfAllGainByIt() {
        double[][] cost = {{1, 2}, {1, 9}};

        assertThat(Assignment.cheapest(cost)).containsExactly(1, 0);
    }

    @Test
    void leavesPlacesFreeIfThereAreMoreThanPlayers() {
        double[][] cost = {{5, 3, 9, 1}};

        assertThat(Assignment.cheapest(cost)).containsExactly(3);
    }

    @Test
    void needsNoPlayers() {
        assertThat(Assignment.cheapest(new double[0][])).isEmpty();
    }

    @Test
    void isAsCheapAsTheBestOfAllPossibilities() {
        Random random = new Random(7);
        for (int trial = 0; trial < 50; trial++) {
            double[][] cost = matrix(random, 5, 6);

            assertThat(sum(cost, Assignment.cheapest(cost))).isCloseTo(best(cost, 0, new boolean[6]), within(1e-9));
        }
    }

    private static double[][] matrix(Random random, int players, int places) {
        double[][] cost = new double[players][places];
        for (double[] row : cost) {
            for (int i = 0; i < places; i++) {
                row[i] = random.nextDouble();
            }
        }
        return cost;
    }

    private static double sum(double[][] cost, int... places) {
        double sum = 0;
        for (int i = 0; i < places.length; i++) {
            sum += cost[i][places[i]];
        }
        return sum;
    }

    private static double best(double[][] cost, int player, boolean... used) {
        double least = player == cost.length ? 0 : Double.POSITIVE_INFINITY;
        for (int place = 0; player < cost.length && place < used.length; place++) {
            if (!used[place]) {
                used[place] = true;
                least = Math.min(least, cost[player][place] + best(cost, player + 1, used));
                used[place] = false;
            }
        }
        return least;
    }
}
