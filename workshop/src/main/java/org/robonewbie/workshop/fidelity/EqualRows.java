package org.robonewbie.workshop.fidelity;

import java.util.OptionalDouble;

/** Counts the rows in which recorded and simulated sensor values are equal within the printed precision. */
final class EqualRows {

    private int rows;
    private int equal;

    void add(boolean isEqual) {
        rows++;
        if (isEqual) {
            equal++;
        }
    }

    /** Returns the share of equal rows, 0 to 1; empty if no row contains a value of the sensor. */
    OptionalDouble share() {
        return rows == 0 ? OptionalDouble.empty() : OptionalDouble.of((double) equal / rows);
    }
}
