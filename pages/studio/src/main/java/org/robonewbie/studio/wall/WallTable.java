package org.robonewbie.studio.wall;

import java.util.List;

/**
 * How a contest stands.
 *
 * @param over the number of trials that are over
 * @param planned the number of trials that are known by now
 * @param columns what the cells of each row mean
 * @param rows one for each team, the best first
 */
public record WallTable(int over, int planned, List<String> columns, List<Place> rows) {

    /** Makes the lists unmodifiable. */
    public WallTable {
        columns = List.copyOf(columns);
        rows = List.copyOf(rows);
    }

    /**
     * The place of one team.
     *
     * @param rank 1 is the best; shared by equals
     * @param team its name
     * @param cells one text for each column
     */
    public record Place(int rank, String team, List<String> cells) {

        /** Makes the list unmodifiable. */
        public Place {
            cells = List.copyOf(cells);
        }
    }
}
