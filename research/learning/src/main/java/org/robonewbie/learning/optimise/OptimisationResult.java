package org.robonewbie.learning.optimise;

import java.util.Locale;

/**
 * Start and result of an optimisation, compared in the same trials, which the search has not seen.
 *
 * @param objective what was to become better
 * @param before how the start did
 * @param after how the result did
 * @param trials how many trials each of them had
 * @param advice what else can be done with the result than to use its file; may be empty
 */
public record OptimisationResult(Objective objective, Evaluation before, Evaluation after, int trials, String advice) {

    /** {@return whether the result does better without failing more often} */
    public boolean isBetter() {
        double gain = after.value() - before.value();
        return after.success() >= before.success() && (objective.isLargerBetter() ? gain > 0 : gain < 0);
    }

    /**
     * Describes an evaluation in words.
     *
     * @param evaluation {@link #before} or {@link #after}
     * @return such as {@code kick-distance 5.612 m, 20 of 20 trials succeed}
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
