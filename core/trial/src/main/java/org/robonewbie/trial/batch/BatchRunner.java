package org.robonewbie.trial.batch;

import java.util.List;
import java.util.function.BiConsumer;

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
     * @throws java.io.UncheckedIOException if a job failed with an {@link java.io.IOException}
     * @throws RuntimeException what a job or the receiver has thrown
     * @throws IllegalStateException if a job failed with another checked exception, or this thread was interrupted
     */
    <P, R> List<R> run(List<P> parameters, Job<P, R> job, BiConsumer<? super P, ? super R> results);

    /**
     * Runs all jobs and waits for the last one.
     *
     * @param <P> the parameters of a job
     * @param <R> the result of a job
     * @param parameters the parameters of each job
     * @param job the work
     * @return all results in the order of the parameters
     */
    default <P, R> List<R> run(List<P> parameters, Job<P, R> job) {
        return run(parameters, job, (one, result) -> {});
    }

    /** Releases threads and connections. */
    @Override
    void close();
}
