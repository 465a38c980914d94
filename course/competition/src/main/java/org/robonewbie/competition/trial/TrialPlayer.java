package org.robonewbie.competition.trial;

import java.io.IOException;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.TrialResult;

/** Runs the trials of a contest. Implementations must be thread-safe. */
@FunctionalInterface
public interface TrialPlayer {

    /**
     * Runs a trial.
     *
     * @param trial the trial
     * @param files output files of the trial
     * @return its result
     * @throws IOException if the simulator or a process cannot be started
     * @throws InterruptedException if this thread is interrupted
     */
    TrialResult run(ContestTrial trial, TrialFiles files) throws IOException, InterruptedException;
}
