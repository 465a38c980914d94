package org.robonewbie.competition.trial;

import java.util.Optional;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.contest.TrialResult;

/**
 * How a contest stands while it is held.
 *
 * @param over the number of trials that are over
 * @param planned the number of trials that are known by now
 * @param table the table as it would be if the contest ended now
 * @param last the trial that has just ended; empty at the beginning
 */
public record ContestProgress(int over, int planned, Table table, Optional<TrialResult> last) {}
