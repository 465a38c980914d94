import java.util.Arrays;
import java.util.Locale;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import org.robonewbie.learning.search.CovarianceMatrixAdaptation;
import org.robonewbie.learning.search.RestartingSearch;

/**
 * Counts the trials that the search of {@code optimise} needs for the functions in {@code beside_cma.py}. Prints one
 * line per function and seed.
 */
public class SearchTrials {

    private static final double GOAL = 1e-9;
    private static final int MAX_TRIALS = 300_000;

    public static void main(String[] words) {
        int seeds = Integer.parseInt(words[0]);
        for (int n : new int[] {5, 10, 22}) {
            count("sphere", n, 1, 0.5, seeds, x -> weighted(x, 1));
            count("ellipsoid", n, 1, 0.5, seeds, x -> weighted(x, 1e6));
            count("rosenbrock", n, 0, 0.5, seeds, SearchTrials::rosenbrock);
        }
        count("rastrigin", 5, 2.3, 2, seeds, SearchTrials::rastrigin);
    }

    private static void count(String name, int n, double centre, double step, int seeds, ToDoubleFunction<double[]> cost) {
        for (int seed = 1; seed <= seeds; seed++) {
            double[] start = new double[n];
            Arrays.fill(start, centre);
            int population = CovarianceMatrixAdaptation.defaultPopulation(n);
            RestartingSearch search = new RestartingSearch(start, step, population, new Random(seed).nextLong());
            System.out.printf(Locale.ROOT, "%s %d %d%n", name, n, trials(search, cost));
        }
    }

    private static int trials(RestartingSearch search, ToDoubleFunction<double[]> cost) {
        int trials = 0;
        while (trials < MAX_TRIALS) {
            double[] costs = search.ask().stream().mapToDouble(cost).toArray();
            trials += costs.length;
            if (Arrays.stream(costs).min().orElseThrow() <= GOAL) {
                break;
            }
            search.tell(costs);
        }
        return trials;
    }

    private static double weighted(double[] x, double greatest) {
        double sum = 0;
        for (int i = 0; i < x.length; i++) {
            sum += Math.pow(greatest, i / (x.length - 1.0)) * x[i] * x[i];
        }
        return sum;
    }

    private static double rosenbrock(double[] x) {
        double sum = 0;
        for (int i = 0; i + 1 < x.length; i++) {
            double bend = x[i] * x[i] - x[i + 1];
            sum += 100 * bend * bend + (1 - x[i]) * (1 - x[i]);
        }
        return sum;
    }

    private static double rastrigin(double[] x) {
        return Arrays.stream(x).map(c -> c * c + 10 - 10 * Math.cos(2 * Math.PI * c)).sum();
    }
}
