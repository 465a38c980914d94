package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.OptionalDouble;

/**
 * What stays constant during a match: dimensions of the pitch and parameters of the rules.
 *
 * @param measures the numbers in the order in which they are sent
 * @param playModes names of all play modes; messages refer to a play mode by its index in this list
 */
public record Environment(List<Measure> measures, List<String> playModes) {

    /** The environment before any was received. */
    public static final Environment UNKNOWN = new Environment(List.of(), List.of());

    /**
     * One number of the environment.
     *
     * @param name SimSpark's name of it, such as {@code FieldLength}
     * @param value metres, seconds or kilograms
     */
    public record Measure(String name, double value) {}

    /**
     * Creates an environment.
     *
     * @param measures the numbers in the order in which they are sent
     * @param playModes names of all play modes
     */
    public Environment {
        measures = List.copyOf(measures);
        playModes = List.copyOf(playModes);
    }

    /**
     * Looks up a number.
     *
     * @param name SimSpark's name of it, such as {@code FieldLength}
     * @return metres, seconds or kilograms; empty if the server did not send it
     */
    public OptionalDouble measure(String name) {
        return measures.stream()
                .filter(measure -> measure.name().equals(name))
                .mapToDouble(Measure::value)
                .findFirst();
    }
}
