package org.robonewbie.competition.contest;

import java.util.List;

/** A kind of contest. It plans trials and ranks their results; who runs them is no matter of it. */
public sealed interface Contest permits ChallengeContest, JudgedContest {

    /** {@return the contest's name on the command line, one word} */
    String name();

    /** {@return the contest's title} */
    String title();

    /** {@return the rule in one or two sentences} */
    String rule();

    /**
     * Plans the trials that are known by now. When all of these are over, it is called again, since some contests continue if
     * no team has won.
     *
     * @param teams names of the teams
     * @param results the results so far
     * @return all trials, over or not, in their order
     */
    List<ContestTrial> trials(List<String> teams, Results results);

    /**
     * Ranks the teams.
     *
     * @param teams names of the teams
     * @param results what is over
     * @return the table; teams whose trials are not over stand last
     */
    Table table(List<String> teams, Results results);
}
