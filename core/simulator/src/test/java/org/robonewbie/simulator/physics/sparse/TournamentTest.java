package org.robonewbie.simulator.physics.sparse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

class TournamentTest {

    @Test
    void alwaysKnowsTheFirstOfThoseWithTheLeastNumber() {
        Random random = new Random(5);
        for (int players = 1; players < 40; players++) {
            int[] numbers = random.ints(players, 0, 5).toArray();
            Tournament tournament = new Tournament();
            tournament.begin(players);
            for (int i = 0; i < players; i++) {
                tournament.enter(i, numbers[i]);
            }
            tournament.play();

            for (int left = players; left > 0; left--) {
                int changed = random.nextInt(players);
                if (numbers[changed] < Integer.MAX_VALUE) {
                    numbers[changed] = random.nextInt(5);
                    tournament.change(changed, numbers[changed]);
                }
                assertThat(tournament.winner()).isEqualTo(firstOfLeast(numbers));
                numbers[tournament.winner()] = Integer.MAX_VALUE;
                tournament.leave(tournament.winner());
            }
        }
    }

    private static int firstOfLeast(int[] numbers) {
        int best = 0;
        for (int i = 1; i < numbers.length; i++) {
            best = numbers[i] < numbers[best] ? i : best;
        }
        return best;
    }
}
