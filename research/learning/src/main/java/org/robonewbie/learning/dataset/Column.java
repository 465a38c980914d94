package org.robonewbie.learning.dataset;

/**
 * One column of a table.
 *
 * @param name such as {@code true_left_knee_pitch}
 * @param kind what its cells are
 * @param unit such as {@code degrees}; empty if there is none
 * @param meaning what it tells, in a few words
 */
public record Column(String name, Kind kind, String unit, String meaning) {

    /** What the cells of a column are. */
    public enum Kind {
        /** {@link Double}; NaN where there is nothing to tell. */
        DECIMAL,
        /** {@link Long}. */
        WHOLE,
        /** {@link String}; empty where there is nothing to tell. */
        TEXT
    }

    static Column decimal(String name, String unit, String meaning) {
        return new Column(name, Kind.DECIMAL, unit, meaning);
    }

    static Column whole(String name, String unit, String meaning) {
        return new Column(name, Kind.WHOLE, unit, meaning);
    }

    static Column text(String name, String meaning) {
        return new Column(name, Kind.TEXT, "", meaning);
    }
}
