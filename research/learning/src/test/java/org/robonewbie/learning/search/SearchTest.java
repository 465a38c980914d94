package org.robonewbie.learning.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SearchTest {

    private static final SearchPlan PLAN = new SearchPlan(3, 0.5, 8, 60, 4, 5);

    @Test
    void findsTheBottomOfANoisyBowl() {
        double[] found = new Search(PLAN, SearchTest::noisyBowl).run(new double[] {2, -2}, progress -> {});

        assertThat(Math.hypot(found[0] - 1, found[1] - 1)).isLessThan(0.2);
    }

    @Test
    void givesTheSameResultEachTimeAlthoughTrialsRunInParallel() {
        Search search = new Search(PLAN, SearchTest::noisyBowl);

        double[] first = search.run(new double[] {2, -2}, progress -> {});
        double[] second = search.run(new double[] {2, -2}, progress -> {});

        assertThat(second).containsExactly(first);
    }

    @Test
    void tellsAboutEachGeneration() {
        List<SearchProgress> told = new ArrayList<>();

        new Search(PLAN, SearchTest::noisyBowl).run(new double[] {2, -2}, told::add);

        assertThat(told).hasSize(60);
        assertThat(told.get(0).toString()).startsWith("generation 0: least cost ");
        assertThat(told.get(59).leastCost()).isLessThan(told.get(0).leastCost());
    }

    @Test
    void aPlanWithoutGenerationsKeepsTheFirstGuess() {
        double[] guess = {2, -2};

        double[] found = new Search(SearchPlan.NONE, SearchTest::noisyBowl).run(guess, progress -> {});

        assertThat(found).containsExactly(guess);
    }

    private static double noisyBowl(double[] x, long seed) {
        double noise = 0.1 * new Random(seed).nextGaussian();
        return noise + Arrays.stream(x).map(v -> (v - 1) * (v - 1)).sum();
    }
}
