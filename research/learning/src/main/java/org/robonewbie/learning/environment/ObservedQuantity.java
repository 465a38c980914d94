package org.robonewbie.learning.environment;

import java.util.List;
import java.util.stream.Stream;

/**
 * One number of an observation.
 *
 * @param name such as {@code joint.LEFT_KNEE_PITCH}
 * @param unit such as {@code degrees}
 * @param least smallest value that is to be expected
 * @param greatest greatest value that is to be expected
 */
public record ObservedQuantity(String name, String unit, double least, double greatest) {

    /**
     * Describes the three components of a vector.
     *
     * @param name such as {@code gyro}
     * @param unit their unit
     * @param most largest amount of each that is to be expected
     * @return one quantity for each axis: forward, left, up
     */
    public static List<ObservedQuantity> vector(String name, String unit, double most) {
        return Stream.of("forward", "left", "up")
                .map(axis -> new ObservedQuantity(name + "." + axis, unit, -most, most))
                .toList();
    }

    /** The same quantity with a range that is wider by a part of it at both ends. */
    ObservedQuantity widened(double part) {
        double room = part * (greatest - least);
        return new ObservedQuantity(name, unit, least - room, greatest + room);
    }

    /** The nearest value within the range. */
    double clamped(double value) {
        return Math.max(least, Math.min(greatest, value));
    }
}
