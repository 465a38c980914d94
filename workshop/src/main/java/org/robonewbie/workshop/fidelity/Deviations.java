package org.robonewbie.workshop.fidelity;

import java.util.Arrays;
import java.util.OptionalDouble;

/** Deviations of one quantity over all rows. */
final class Deviations {

    private double[] values = new double[1024];
    private int count;

    void add(double value) {
        if (count == values.length) {
            values = Arrays.copyOf(values, 2 * count);
        }
        values[count++] = value;
    }

    /** Returns the median; empty if there are no values. */
    OptionalDouble median() {
        double[] sorted = Arrays.copyOf(values, count);
        Arrays.sort(sorted);
        return count == 0 ? OptionalDouble.empty() : OptionalDouble.of(sorted[count / 2]);
    }

    /** Returns the maximum; empty if there are no values, NaN if any value is NaN. */
    OptionalDouble max() {
        return Arrays.stream(values, 0, count).max();
    }
}
