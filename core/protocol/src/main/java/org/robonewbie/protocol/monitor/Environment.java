package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.OptionalDouble;

/**
 * The constants of a match: dimensions of the pitch and parameters of the rules.
 *
 * @param measures the parameters, in the order in which they appear in the message
 * @param playModes names of all play modes; messages refer to a play mode by its index in this list
 */
public record Environment(List<Measure> measures, List<String> playModes) {

    /** The environment before the first message. */
    public static final Environment UNKNOWN = new Environment(List.of(), List.of());

    /**
     * A parameter of the environment.
     *
     * @param name SimSpark's name, such as {@code FieldLength}
     * @param value value in metres, seconds or kilograms
     */
    public record Measure(String name, double value) {}

    /** Stores unmodifiable copies of the lists. */
    public Environment {
        measures = List.copyOf(measures);
        playModes = List.copyOf(playModes);
    }

    /**
     * Returns a parameter.
     *
     * @param name SimSpark's name, such as {@code FieldLength}
     * @return value in metres, seconds or kilograms; empty if the server did not send it
     */
    public OptionalDouble measure(String name) {
        return measures.stream()
                .filter(measure -> measure.name().equals(name))
                .mapToDouble(Measure::value)
                .findFirst();
    }
}
