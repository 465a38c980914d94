package org.robonewbie.competition.contest;

/** A contest on the pitch, where programs play as in a game and a judge watches. */
public non-sealed interface JudgedContest extends Contest {

    /**
     * Sends a judge to a trial.
     *
     * @param trial one of the trials
     * @return its judge
     */
    Judge judge(ContestTrial trial);
}
