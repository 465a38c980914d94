package org.robonewbie.agent;

import java.io.Serializable;

/**
 * A number in a robot's program that can be tuned.
 *
 * @param name what the program calls it
 * @param usual its default value
 * @param least smallest sensible value
 * @param most largest sensible value
 * @param value its value in this robot
 */
public record TunableNumber(String name, double usual, double least, double most, double value)
        implements Serializable {

    /** Returns the number with another value, or with the nearest one that it may have. */
    TunableNumber withValue(double wanted) {
        double taken = Double.isNaN(wanted) ? value : Math.max(least, Math.min(most, wanted));
        return new TunableNumber(name, usual, least, most, taken);
    }
}
