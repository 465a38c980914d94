package org.robonewbie.simulator.physics.sparse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

class TournamentTreeTest {

    @Test
    void alwaysKnowsTheFirstOfThoseWithTheLeastNumber() {
        Random random = new Random(5);
        for (int players = 1; players < 40; players++) {
            int[] numbers = random.ints(players, 0, 5).toArray();
            TournamentTree tournamentTree = new TournamentTree();
            tournamentTree.reset(players);
            for (int i = 0; i < players; i++) {
                tournamentTree.add(i, numbers[i]);
            }
            tournamentTree.build();

            for (int left = players; left > 0; left--) {
                int changed = random.nextInt(players);
                if (numbers[changed] < Integer.MAX_VALUE) {
                    numbers[changed] = random.nextInt(5);
                    tournamentTree.update(changed, numbers[changed]);
                }
                assertThat(tournamentTree.minimum()).isEqualTo(firstOfLeast(numbers));
                numbers[tournamentTree.minimum()] = Integer.MAX_VALUE;
                tournamentTree.remove(tournamentTree.minimum());
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
