package org.robonewbie.competition.contest;

import java.util.List;

/**
 * The result of a contest.
 *
 * @param title of the contest
 * @param rule how it was judged
 * @param columns what the cells of each row mean
 * @param rows one for each team, the best first
 */
public record Table(String title, String rule, List<String> columns, List<Row> rows) {

    /** Makes the lists unmodifiable. */
    public Table {
        columns = List.copyOf(columns);
        rows = List.copyOf(rows);
    }

    /**
     * One team in the table.
     *
     * @param rank its place, 1 is the best; shared by equals
     * @param team its name
     * @param cells one text for each column
     * @param trials names of its trials
     * @param certified whether it gets a certificate; a program that has lost all its trials does not
     */
    public record Row(int rank, String team, List<String> cells, List<String> trials, boolean certified) {

        /** Makes the lists unmodifiable. */
        public Row {
            cells = List.copyOf(cells);
            trials = List.copyOf(trials);
        }

        /**
         * Creates the row of a team that took part.
         *
         * @param rank its place
         * @param team its name
         * @param cells one text for each column
         * @param trials names of its trials
         */
        public Row(int rank, String team, List<String> cells, List<String> trials) {
            this(rank, team, cells, trials, true);
        }
    }
}
