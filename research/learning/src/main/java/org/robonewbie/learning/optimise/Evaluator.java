package org.robonewbie.learning.optimise;

import java.util.List;

/** Carries out trials of candidates; where that happens never changes the result. */
interface Evaluator extends AutoCloseable {

    /**
     * Tries each candidate under each circumstance.
     *
     * @param candidates how far each number of the subject is changed
     * @param seeds the circumstances
     * @return the outcomes: those of the first candidate in the order of the seeds, then those of the next one
     * @throws IllegalStateException if a trial failed; the message says which and why
     */
    List<Evaluation> all(List<double[]> candidates, List<Long> seeds);

    @Override
    void close();
}
