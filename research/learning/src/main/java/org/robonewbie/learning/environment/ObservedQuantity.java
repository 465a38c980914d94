package org.robonewbie.learning.environment;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.Quantity;

/**
 * One component of an observation. The JSON in docs/gym-protocol.md uses the names of these record components.
 *
 * @param name a name such as {@code joint.LEFT_KNEE_PITCH}
 * @param unit a unit such as {@code degrees}
 * @param least lower bound of the expected values
 * @param greatest upper bound of the expected values
 */
public record ObservedQuantity(String name, String unit, double least, double greatest) {

    /**
     * Describes the three components of a vector.
     *
     * @param name a name such as {@code gyro}
     * @param unit the unit of the components
     * @param max upper bound of their absolute values
     * @return one quantity for each axis: forward, left, up
     */
    public static List<ObservedQuantity> vector(String name, String unit, double max) {
        return Stream.of("forward", "left", "up")
                .map(axis -> symmetric(name + "." + axis, unit, max))
                .toList();
    }

    static ObservedQuantity symmetric(String name, String unit, double max) {
        return new ObservedQuantity(name, unit, -max, max);
    }

    /** Describes the inputs of a policy, whose absolute values are at most {@code max}. */
    static List<ObservedQuantity> symmetric(List<Quantity> inputs, double max) {
        return inputs.stream()
                .map(input -> symmetric(input.name(), input.unit(), max))
                .toList();
    }

    /** Returns the same quantity in the observation of an earlier action: {@code gyro.left@-1} is one action old. */
    ObservedQuantity ago(int actions) {
        return actions == 0
                ? this
                : new ObservedQuantity(new Quantity(name, unit).ago(actions).name(), unit, least, greatest);
    }

    /** Returns a copy whose range is extended at both ends by a fraction of its length. */
    ObservedQuantity widened(double share) {
        double margin = share * (greatest - least);
        return new ObservedQuantity(name, unit, least - margin, greatest + margin);
    }

    double clamped(double value) {
        return Math.max(least, Math.min(greatest, value));
    }
}
