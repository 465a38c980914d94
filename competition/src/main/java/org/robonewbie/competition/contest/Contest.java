package org.robonewbie.competition.contest;

import java.util.List;

/** A kind of contest. It plans trials and ranks their results; who runs them is no matter of it. */
public interface Contest {

    /**
     * Names the contest.
     *
     * @return one word, as it stands on the command line
     */
    String name();

    /**
     * Names the contest for people.
     *
     * @return a title
     */
    String title();

    /**
     * Says how it is judged.
     *
     * @return one or two sentences
     */
    String rule();

    /**
     * Plans the trials, as far as they are known by now. When all of these are over, it is asked again, since some contests
     * go on if nobody has won.
     *
     * @param teams names of the teams
     * @param results what is over
     * @return all trials, over or not, in their order
     */
    List<Trial> trials(List<String> teams, Results results);

    /**
     * Sends somebody who watches a trial.
     *
     * @param trial one of the trials
     * @return its judge
     */
    Judge judge(Trial trial);

    /**
     * Ranks the teams.
     *
     * @param teams names of the teams
     * @param results what is over
     * @return the table; teams whose trials are not over stand last
     */
    Table table(List<String> teams, Results results);
}
