package org.robonewbie.competition.trial;

import java.io.IOException;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.TrialResult;

/** Plays the trials of a contest; several at the same time, from several threads. */
@FunctionalInterface
public interface TrialPlayer {

    /**
     * Runs a trial to its end.
     *
     * @param trial the trial
     * @param files where to put what is written
     * @return its result
     * @throws IOException if no simulator or process can be started
     * @throws InterruptedException if this thread is interrupted
     */
    TrialResult run(ContestTrial trial, TrialFiles files) throws IOException, InterruptedException;
}
