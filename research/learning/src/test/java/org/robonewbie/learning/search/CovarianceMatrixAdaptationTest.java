package org.robonewbie.learning.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

class CovarianceMatrixAdaptationTest {

    @Test
    void findsTheCentreOfASphere() {
        double[] start = new double[10];
        Arrays.fill(start, 3);

        CovarianceMatrixAdaptation search = minimise(start, 200, CovarianceMatrixAdaptationTest::sphere);

        assertThat(sphere(search.mean())).isLessThan(1e-10);
    }

    @Test
    void followsTheBentValleyOfRosenbrock() {
        double[] start = new double[6];

        CovarianceMatrixAdaptation search = minimise(start, 700, CovarianceMatrixAdaptationTest::rosenbrock);

        assertThat(rosenbrock(search.mean())).isLessThan(1e-8);
        assertThat(search.mean()).containsExactly(new double[] {1, 1, 1, 1, 1, 1}, within(1e-3));
    }

    @Test
    void learnsScalesThatDifferByAThousand() {
        double[] start = {1, 1, 1, 1};

        ToDoubleFunction<double[]> cost = x -> x[0] * x[0] + 1e6 * x[1] * x[1] + x[2] * x[2] + 1e6 * x[3] * x[3];

        CovarianceMatrixAdaptation search = minimise(start, 400, cost);

        assertThat(cost.applyAsDouble(search.mean())).isLessThan(1e-8);
    }

    @Test
    void givesTheSameAnswerForTheSameSeed() {
        double[] start = {1, 2, 3};

        double[] first =
                minimise(start, 20, CovarianceMatrixAdaptationTest::sphere).mean();
        double[] second =
                minimise(start, 20, CovarianceMatrixAdaptationTest::sphere).mean();

        assertThat(second).containsExactly(first);
    }

    @Test
    void countsNotANumberAsTheWorstCost() {
        double[] start = {2, 2};

        CovarianceMatrixAdaptation search = minimise(start, 100, x -> x[0] < 0 ? Double.NaN : sphere(x));

        assertThat(sphere(search.mean())).isLessThan(1e-4);
    }

    @Test
    void refusesCostsWithoutCandidates() {
        var search = new CovarianceMatrixAdaptation(new double[] {1}, 1, 4, 1);

        assertThatThrownBy(() -> search.tell(new double[] {1, 2, 3, 4}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("4 costs for 0 candidates. Call tell() once after each ask().");
    }

    @Test
    void refusesASearchThatCannotWork() {
        assertThatThrownBy(() -> new CovarianceMatrixAdaptation(new double[0], 1, 4, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("0 coordinates, step 1.0 and population 4");
    }

    private static CovarianceMatrixAdaptation minimise(
            double[] start, int generations, ToDoubleFunction<double[]> cost) {
        var search = new CovarianceMatrixAdaptation(start, 0.5, 12, 42);
        for (int i = 0; i < generations; i++) {
            List<double[]> candidates = search.ask();
            search.tell(candidates.stream().mapToDouble(cost).toArray());
        }
        return search;
    }

    private static double sphere(double[] x) {
        return Arrays.stream(x).map(v -> v * v).sum();
    }

    private static double rosenbrock(double[] x) {
        double sum = 0;
        for (int i = 0; i + 1 < x.length; i++) {
            double bend = x[i + 1] - x[i] * x[i];
            sum += 100 * bend * bend + (1 - x[i]) * (1 - x[i]);
        }
        return sum;
    }
}
