package org.robonewbie.learning.optimise;

/** Listener for the progress of an optimisation. It is never called concurrently. */
@FunctionalInterface
public interface OptimisationListener {

    /**
     * Called before the first generation.
     *
     * @param before the evaluation of the initial values
     */
    default void begins(Evaluation before) {}

    /**
     * Called after each generation. A resumed search first calls this method for the earlier generations.
     *
     * @param generation the result of the generation
     */
    void reached(Generation generation);

    /**
     * Called at the end. If the result is better than the initial values, it has been written.
     *
     * @param result the comparison of the initial values and the result
     */
    default void ends(OptimisationResult result) {}
}
