package org.robonewbie.trial.batch;

import java.io.IOException;
import java.util.List;

/**
 * Runs the jobs of a batch in parallel. The choice of a runner never changes a result. Runners of add-ons are found by {@link
 * java.util.ServiceLoader}.
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
     * Runs all jobs and waits for the last one. The first failure ends the batch.
     *
     * @param <P> the parameters of a job
     * @param <R> the result of a job
     * @param parameters the parameters of each job
     * @param job the work
     * @param results receives each result as soon as it is known, in any order, one at a time
     * @return all results in the order of the parameters
     * @throws IOException the I/O failure of a job or of the receiver
     * @throws IllegalStateException if a job failed with another checked exception, or this thread was interrupted
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
     * @throws IOException the I/O failure of a job
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
         * @throws IOException if the result cannot be kept; the batch ends then
         */
        void accept(P parameters, R result) throws IOException;
    }

    /** Releases threads and connections. */
    @Override
    void close();
}
