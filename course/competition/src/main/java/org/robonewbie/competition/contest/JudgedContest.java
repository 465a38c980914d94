package org.robonewbie.competition.contest;

/** Contest whose trials are games on a complete simulator, each scored by a judge. */
public non-sealed interface JudgedContest extends Contest {

    /**
     * Creates the judge for a trial.
     *
     * @param trial one of the trials
     * @return a new judge
     */
    Judge judge(ContestTrial trial);
}
