package org.robonewbie.learning.optimise;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.learning.search.AskAndTell;

/**
 * Distribution of the next candidates of a search, in coordinates of its {@link Parametrization}.
 *
 * @param step the step size (sigma), which approaches 0 as the search converges
 * @param middle the mean, which is the current result
 * @param spread the standard deviation in each coordinate
 */
public record SearchDistribution(double step, List<Double> middle, List<Double> spread) {

    /** Stores unmodifiable copies of the lists. */
    public SearchDistribution {
        middle = List.copyOf(middle);
        spread = List.copyOf(spread);
    }

    static SearchDistribution of(AskAndTell search) {
        return new SearchDistribution(
                search.distribution().step(),
                list(search.mean()),
                list(search.distribution().spread()));
    }

    private static List<Double> list(double[] numbers) {
        return Arrays.stream(numbers).boxed().toList();
    }
}
