package org.robonewbie.learning.optimise;

import java.util.Locale;

/**
 * Comparison of the initial values and the result of an optimisation in the same trials, with seeds that the search has not used.
 *
 * @param objective the objective
 * @param before the evaluation of the initial values
 * @param after the evaluation of the result
 * @param trials the number of trials of each evaluation
 * @param advice how to use the result without its file; may be empty
 */
public record OptimisationResult(Objective objective, Evaluation before, Evaluation after, int trials, String advice) {

    /** {@return whether the value of the result is better and its success rate is not lower} */
    public boolean isBetter() {
        double gain = after.value() - before.value();
        return after.success() >= before.success() && (objective.isLargerBetter() ? gain > 0 : gain < 0);
    }

    /**
     * Describes an evaluation.
     *
     * @param evaluation {@link #before} or {@link #after}
     * @return a description such as {@code kick-distance 5.612 m, 20 of 20 trials succeed}
     */
    public String words(Evaluation evaluation) {
        return String.format(
                Locale.ROOT,
                "%s %.3f %s, %d of %d trials succeed",
                objective.label(),
                evaluation.value(),
                objective.unit(),
                Math.round(evaluation.success() * trials),
                trials);
    }
}
