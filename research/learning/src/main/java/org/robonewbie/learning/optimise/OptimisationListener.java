package org.robonewbie.learning.optimise;

/** Receives the progress of an optimisation; one call at a time. */
@FunctionalInterface
public interface OptimisationListener {

    /**
     * Hears how well the start does, before the first generation.
     *
     * @param before the mean of the trials of comparison
     */
    default void begins(Evaluation before) {}

    /**
     * Called for each generation. After an interruption it is first called again for the earlier ones.
     *
     * @param generation what it has reached
     */
    void reached(Generation generation);

    /**
     * Hears what came out; the file of the result is written already if it is better.
     *
     * @param result the comparison with the start
     */
    default void ends(OptimisationResult result) {}
}
