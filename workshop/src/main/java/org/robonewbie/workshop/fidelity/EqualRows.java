package org.robonewbie.workshop.fidelity;

import java.util.OptionalDouble;

/** Counts the rows in which a sensor printed the same. */
final class EqualRows {

    private int rows;
    private int equal;

    void add(boolean isEqual) {
        rows++;
        if (isEqual) {
            equal++;
        }
    }

    /** Share of equal rows from 0 to 1, empty when no row had the sensor. */
    OptionalDouble share() {
        return rows == 0 ? OptionalDouble.empty() : OptionalDouble.of((double) equal / rows);
    }
}
