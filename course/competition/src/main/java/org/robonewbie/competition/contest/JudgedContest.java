package org.robonewbie.competition.contest;

/** Contest in which each trial is a game in a full simulator, scored by a judge. */
public non-sealed interface JudgedContest extends Contest {

    /**
     * Creates the judge for a trial.
     *
     * @param trial a trial of this contest
     * @return a new judge
     */
    Judge judge(ContestTrial trial);
}
