package org.robonewbie.protocol.telemetry;

import java.util.Optional;

/**
 * A request to change the value of a tunable parameter that a robot's program has declared. Its text format is one line
 * of tab-separated fields:
 *
 * <pre>
 * tune  Blue  3  gain  0.75
 * </pre>
 *
 * @param team name of the robot's team
 * @param number the robot's shirt number, 1 to 11
 * @param name name of the parameter in the program
 * @param value new value, in the unit that the program uses
 */
public record TuningRequest(String team, int number, String name, double value) {

    private static final String KIND = "tune";

    /** {@return the request as one line without its line terminator} */
    public String write() {
        return new FieldWriter(KIND)
                .text(team)
                .text(Integer.toString(number))
                .text(name)
                .text(Double.toString(value))
                .toString();
    }

    /**
     * Parses a request.
     *
     * @param line one line without its line terminator
     * @return the request; empty if the line is not a request
     */
    public static Optional<TuningRequest> read(String line) {
        try {
            FieldReader fields = new FieldReader(line);
            return fields.text().equals(KIND)
                    ? Optional.of(new TuningRequest(
                            fields.text(), Integer.parseInt(fields.text()), fields.text(), fields.number()))
                    : Optional.empty();
        } catch (IllegalArgumentException notARequest) {
            return Optional.empty();
        }
    }
}
