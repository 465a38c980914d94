package org.robonewbie.learning.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

class RestartingSearchTest {

    private static final int GENERATIONS = 2500;

    private final Set<CovarianceMatrixAdaptation> runs = new HashSet<>();

    @Test
    void findsTheDeepestOfManyHollows() {
        RestartingSearch search = new RestartingSearch(start(), 2, 7, 1);

        minimise(search, RestartingSearchTest::rastrigin);

        assertThat(runs).hasSizeGreaterThan(1);
        assertThat(search.mean()).containsExactly(new double[] {0, 0, 0}, within(1e-3));
    }

    @Test
    void singleRunEndsInOneOfTheOthers() {
        AskAndTell single = new CovarianceMatrixAdaptation(start(), 2, 7, 1);

        minimise(single, RestartingSearchTest::rastrigin);

        assertThat(rastrigin(single.mean())).isGreaterThan(0.5);
    }

    @Test
    void drawsTwiceAsManyOrFewerCandidatesWhenItBeginsAgain() {
        RestartingSearch search = new RestartingSearch(start(), 2, 8, 1);

        List<Integer> populations = minimise(search, RestartingSearchTest::rastrigin);

        assertThat(populations.get(0)).isEqualTo(8);
        assertThat(populations).contains(16, 32).anyMatch(count -> count < 8);
    }

    @Test
    void remembersTheBestRunWhileOthersGoOn() {
        RestartingSearch search = new RestartingSearch(new double[] {4, 4}, 0.5, 6, 3);
        minimise(search, x -> x[0] * x[0] + x[1] * x[1]);

        assertThat(runs).hasSizeGreaterThan(1);
        assertThat(search.mean()).containsExactly(new double[] {0, 0}, within(1e-4));
    }

    @Test
    void doesNotBeginAgainWhileItGetsBetter() {
        RestartingSearch search = new RestartingSearch(start(), 0.5, 7, 1);
        CovarianceMatrixAdaptation first = search.distribution();
        for (int i = 0; i < 60; i++) {
            search.tell(search.ask().stream()
                    .mapToDouble(RestartingSearchTest::bowl)
                    .toArray());
        }

        assertThat(search.distribution()).isSameAs(first);
    }

    @Test
    void beginsAgainWhenCostsAreAllTheSame() {
        RestartingSearch search = new RestartingSearch(start(), 1, 7, 1);

        minimise(search, x -> 5);

        assertThat(runs).hasSizeGreaterThan(2);
    }

    @Test
    void sameSeedGivesTheSameAnswer() {
        RestartingSearch first = new RestartingSearch(start(), 2, 7, 9);
        RestartingSearch second = new RestartingSearch(start(), 2, 7, 9);

        assertThat(minimise(first, RestartingSearchTest::rastrigin))
                .isEqualTo(minimise(second, RestartingSearchTest::rastrigin));
        assertThat(second.mean()).containsExactly(first.mean());
    }

    /** Returns how many candidates there were in each generation. */
    private List<Integer> minimise(AskAndTell search, ToDoubleFunction<double[]> cost) {
        List<Integer> populations = new ArrayList<>();
        for (int i = 0; i < GENERATIONS; i++) {
            List<double[]> candidates = search.ask();
            populations.add(candidates.size());
            search.tell(candidates.stream().mapToDouble(cost).toArray());
            runs.add(search.distribution());
        }
        return populations;
    }

    private static double[] start() {
        return new double[] {2.3, 2.3, 2.3};
    }

    private static double bowl(double[] x) {
        return Arrays.stream(x).map(v -> v * v).sum();
    }

    private static double rastrigin(double[] x) {
        return Arrays.stream(x)
                .map(v -> 10 + v * v - 10 * Math.cos(2 * Math.PI * v))
                .sum();
    }
}
