package org.robonewbie.learning.optimise;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.learning.search.AskAndTell;

/**
 * From where the next candidates of a search are drawn, in coordinates of its {@link Subject}.
 *
 * @param step size of the whole cloud (sigma); a search that has settled makes it small
 * @param middle the centre, which would be the result if the search ended now
 * @param spread standard deviation in each coordinate
 */
public record SearchDistribution(double step, List<Double> middle, List<Double> spread) {

    /** Copies the lists. */
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
