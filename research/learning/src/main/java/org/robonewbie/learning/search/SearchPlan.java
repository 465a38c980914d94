package org.robonewbie.learning.search;

/**
 * How long and how widely a search looks.
 *
 * @param seed chooses the candidates and the trials; the same seed gives the same result
 * @param step spread of the first candidates in each coordinate
 * @param population candidates in each generation
 * @param generations how often candidates are drawn
 * @param trials trials of each candidate; its cost is their mean, drawn towards the worst of them
 * @param keepTrials for how many generations the same trials are used before new ones are drawn
 */
public record SearchPlan(long seed, double step, int population, int generations, int trials, int keepTrials) {

    /** No search at all: the first guess is the result. */
    public static final SearchPlan NONE = new SearchPlan(0, 1, 4, 0, 1, 1);
}
