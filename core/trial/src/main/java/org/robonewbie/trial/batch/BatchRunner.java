package org.robonewbie.trial.batch;

import java.io.IOException;
import java.util.List;

/**
 * Runs the jobs of a batch in parallel. Results do not depend on the choice of runner. Add-ons provide further runners through
 * {@link java.util.ServiceLoader}.
 *
 * <pre>{@code
 * try (BatchRunner runner = new ThreadRunner(4); Journal journal = Journal.open(file, "steps 1 to 100")) {
 *     runner.run(seeds, seed -> steps(seed), (seed, steps) -> journal.add(seed + "," + steps));
 * }
 * }</pre>
 */
public interface BatchRunner extends AutoCloseable {

    /** {@return the name on the command line, such as {@code local}} */
    String label();

    /**
     * Runs all jobs and waits for the last one. The first failure stops the batch.
     *
     * @param <P> the parameters of a job
     * @param <R> the result of a job
     * @param parameters the parameters of each job
     * @param job the work
     * @param results receives each result as soon as it is available, in any order; calls do not overlap
     * @return all results in the order of the parameters
     * @throws IOException if a job or the receiver fails with an I/O error
     * @throws IllegalStateException if a job fails with another checked exception, or this thread is interrupted
     */
    <P, R> List<R> run(List<P> parameters, Job<P, R> job, Receiver<? super P, ? super R> results) throws IOException;

    /**
     * Runs all jobs and waits for the last one.
     *
     * @param <P> the parameters of a job
     * @param <R> the result of a job
     * @param parameters the parameters of each job
     * @param job the work
     * @return all results in the order of the parameters
     * @throws IOException if a job fails with an I/O error
     */
    default <P, R> List<R> run(List<P> parameters, Job<P, R> job) throws IOException {
        return run(parameters, job, (one, result) -> {});
    }

    /**
     * Receives results.
     *
     * @param <P> the parameters of a job
     * @param <R> the result of a job
     */
    @FunctionalInterface
    interface Receiver<P, R> {

        /**
         * Receives one result.
         *
         * @param parameters the parameters of the job
         * @param result its result
         * @throws IOException if the result cannot be stored, which stops the batch
         */
        void accept(P parameters, R result) throws IOException;
    }

    /** Releases threads and connections. */
    @Override
    void close();
}
