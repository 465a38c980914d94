package org.robonewbie.studio.wall;

import java.util.List;

/**
 * Results table of a contest.
 *
 * @param over number of finished trials
 * @param planned number of trials planned so far
 * @param columns column headings
 * @param rows one row per team, best first
 */
public record WallTable(int over, int planned, List<String> columns, List<Place> rows) {

    /** Defensively copies the lists. */
    public WallTable {
        columns = List.copyOf(columns);
        rows = List.copyOf(rows);
    }

    /**
     * Row of one team.
     *
     * @param rank rank of the team, 1 for the best; teams that tie share a rank
     * @param team its name
     * @param cells contents of the row's cells, one per column
     */
    public record Place(int rank, String team, List<String> cells) {

        /** Defensively copies the list. */
        public Place {
            cells = List.copyOf(cells);
        }
    }
}
