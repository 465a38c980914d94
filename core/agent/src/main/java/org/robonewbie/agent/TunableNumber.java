package org.robonewbie.agent;

import java.io.Serializable;

/**
 * A tunable number of a robot program, see {@link Agent#number}.
 *
 * @param name name of the number
 * @param usual default value
 * @param least smallest sensible value
 * @param most largest sensible value
 * @param value current value
 */
public record TunableNumber(String name, double usual, double least, double most, double value)
        implements Serializable {

    /** Returns a copy with the given value, clamped to the range of the number. */
    TunableNumber withValue(double wanted) {
        double taken = Double.isNaN(wanted) ? value : Math.max(least, Math.min(most, wanted));
        return new TunableNumber(name, usual, least, most, taken);
    }
}
