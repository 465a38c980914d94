package org.robonewbie.competition.contest;

/** Contest of games with a simulator, in which a judge scores each trial. */
public non-sealed interface JudgedContest extends Contest {

    /**
     * Creates the judge of a trial.
     *
     * @param trial one of the trials
     * @return a new judge
     */
    Judge judge(ContestTrial trial);
}
