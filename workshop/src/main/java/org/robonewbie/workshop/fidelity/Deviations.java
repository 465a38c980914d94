package org.robonewbie.workshop.fidelity;

import java.util.Arrays;
import java.util.OptionalDouble;

/** Collects the deviation of one quantity in each row. */
final class Deviations {

    private double[] values = new double[1024];
    private int count;

    void add(double value) {
        if (count == values.length) {
            values = Arrays.copyOf(values, 2 * count);
        }
        values[count++] = value;
    }

    /** Middle of all values, empty without any. */
    OptionalDouble median() {
        double[] sorted = Arrays.copyOf(values, count);
        Arrays.sort(sorted);
        return count == 0 ? OptionalDouble.empty() : OptionalDouble.of(sorted[count / 2]);
    }

    /** Largest value, empty without any; NaN when one of them is. */
    OptionalDouble max() {
        return Arrays.stream(values, 0, count).max();
    }
}
