/**
 * Parallel execution of many jobs, such as trials with different seeds: {@link org.robonewbie.trial.batch.BatchRunner} runs
 * them, {@link org.robonewbie.trial.batch.Journal} stores each result as it arrives so that an interrupted run can resume, and
 * {@link org.robonewbie.trial.batch.BatchProgress} shows how much is done.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.batch;
