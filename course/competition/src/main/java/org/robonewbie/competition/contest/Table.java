package org.robonewbie.competition.contest;

import java.util.List;

/**
 * Result table of a contest.
 *
 * @param title title of the contest
 * @param rule scoring rule
 * @param columns column headings
 * @param rows one row per team, best first
 */
public record Table(String title, String rule, List<String> columns, List<Row> rows) {

    /** Creates the table. */
    public Table {
        columns = List.copyOf(columns);
        rows = List.copyOf(rows);
    }

    /**
     * Row of one team.
     *
     * @param rank rank, where 1 is the best; tied teams share a rank
     * @param team name of the team
     * @param cells the text of each column
     * @param trials names of its trials
     * @param certified whether the team gets a certificate, which requires at least one trial played to the end
     */
    public record Row(int rank, String team, List<String> cells, List<String> trials, boolean certified) {

        /** Creates the row. */
        public Row {
            cells = List.copyOf(cells);
            trials = List.copyOf(trials);
        }

        /**
         * Creates the row of a team that took part.
         *
         * @param rank rank, where 1 is the best
         * @param team name of the team
         * @param cells the text of each column
         * @param trials names of its trials
         */
        public Row(int rank, String team, List<String> cells, List<String> trials) {
            this(rank, team, cells, trials, true);
        }
    }
}
