package org.robonewbie.competition.trial;

import java.util.Optional;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.contest.TrialResult;

/**
 * Progress of a contest.
 *
 * @param over number of finished trials
 * @param planned number of trials planned so far
 * @param table current table
 * @param last the trial that finished last; empty before the first trial has finished
 */
public record ContestProgress(int over, int planned, Table table, Optional<TrialResult> last) {}
