package org.robonewbie.trial.batch;

import java.io.Serializable;

/**
 * The work of a batch, such as a trial with one seed. The result must depend only on the parameters. Serializable, because a
 * runner may send it to another computer.
 *
 * @param <P> the parameters of one job, including its seed
 * @param <R> its result
 */
@FunctionalInterface
public interface Job<P, R> extends Serializable {

    /**
     * Runs one job.
     *
     * @param parameters the parameters of this job
     * @return its result
     * @throws Exception if the job fails, which stops the batch
     */
    R run(P parameters) throws Exception;
}
