package org.robonewbie.competition.contest;

import java.util.List;

/** Plans the trials of a contest and ranks the teams, but does not run the trials. */
public sealed interface Contest permits ChallengeContest, JudgedContest {

    /** {@return the contest's name on the command line, one word} */
    String name();

    /** {@return the contest's title} */
    String title();

    /** {@return the scoring rule in one or two sentences} */
    String rule();

    /**
     * Returns the trials that can be planned so far. Called again when these trials have finished, because a contest may
     * need further trials to break a tie.
     *
     * @param teams names of the teams
     * @param results results of the finished trials
     * @return all trials, finished or not, in playing order
     */
    List<ContestTrial> trials(List<String> teams, Results results);

    /**
     * Ranks the teams.
     *
     * @param teams names of the teams
     * @param results results of the finished trials
     * @return the table; teams without finished trials are last
     */
    Table table(List<String> teams, Results results);
}
