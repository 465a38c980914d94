package org.robonewbie.learning.search;

import java.util.Locale;

/**
 * What a search has reached.
 *
 * @param generation number of the generation, from 0
 * @param leastCost the smallest cost in it
 * @param meanCost the mean cost in it
 * @param step the present spread of the candidates
 * @param mean their present centre; not to be changed
 */
@SuppressWarnings("ArrayRecordComponent")
public record SearchProgress(int generation, double leastCost, double meanCost, double step, double[] mean) {

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "generation %d: least cost %.3f, mean cost %.3f, step %.3f",
                generation,
                leastCost,
                meanCost,
                step);
    }
}
