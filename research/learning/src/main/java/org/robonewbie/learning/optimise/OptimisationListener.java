package org.robonewbie.learning.optimise;

/** Listener for the progress of an optimisation. It is never called concurrently. */
@FunctionalInterface
public interface OptimisationListener {

    /**
     * Called before the first generation.
     *
     * @param before the evaluation of the start
     */
    default void begins(Evaluation before) {}

    /**
     * Called after each generation. A resumed search first calls it for the earlier generations.
     *
     * @param generation the result of the generation
     */
    void reached(Generation generation);

    /**
     * Called at the end. If the result is better than the start, it has been written.
     *
     * @param result the comparison of start and result
     */
    default void ends(OptimisationResult result) {}
}
