package org.robonewbie.protocol.telemetry;

import java.util.Optional;

/**
 * Somebody wants another value for a number that a robot's program has declared. As a line, separated by tabs:
 *
 * <pre>
 * tune  Blue  3  gain  0.75
 * </pre>
 *
 * @param team name of the robot's team
 * @param number its shirt number, 1 to 11
 * @param name what the program calls the number
 * @param value its new value, in the unit of the program
 */
public record NumberWish(String team, int number, String name, double value) {

    private static final String KIND = "tune";

    /** {@return the wish as one line without its end} */
    public String write() {
        return new FieldWriter(KIND)
                .text(team)
                .text(Integer.toString(number))
                .text(name)
                .text(Double.toString(value))
                .toString();
    }

    /**
     * Reads a wish.
     *
     * @param line one line without its end
     * @return the wish; empty if the line is none
     */
    public static Optional<NumberWish> read(String line) {
        try {
            FieldReader fields = new FieldReader(line);
            return fields.text().equals(KIND)
                    ? Optional.of(new NumberWish(
                            fields.text(), Integer.parseInt(fields.text()), fields.text(), fields.number()))
                    : Optional.empty();
        } catch (IllegalArgumentException noWish) {
            return Optional.empty();
        }
    }
}
