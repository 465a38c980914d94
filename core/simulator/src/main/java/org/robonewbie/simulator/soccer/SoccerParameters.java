package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.math.PortableMath;

/**
 * Immutable values of all {@link SoccerParameter}s.
 *
 * <pre>{@code
 * SoccerParameters parameters = SoccerParameters.league().with("RuleHalfTime=60");
 * double seconds = parameters.get(SoccerParameter.RULE_HALF_TIME);
 * }</pre>
 */
public final class SoccerParameters {

    private static final Set<SoccerParameter> POSITIVE = EnumSet.of(
            SoccerParameter.FIELD_LENGTH,
            SoccerParameter.FIELD_WIDTH,
            SoccerParameter.GOAL_WIDTH,
            SoccerParameter.GOAL_DEPTH,
            SoccerParameter.GOAL_HEIGHT,
            SoccerParameter.AGENT_RADIUS,
            SoccerParameter.BALL_RADIUS,
            SoccerParameter.BALL_MASS);
    private static final Set<SoccerParameter> ANY_SIGN =
            EnumSet.of(SoccerParameter.KEEPAWAY_CENTER_X, SoccerParameter.KEEPAWAY_CENTER_Y);

    private final double[] values;

    private SoccerParameters(double[] values) {
        this.values = values;
    }

    /** {@return the league profile with the values of rcssserver3d 0.7.3} */
    public static SoccerParameters league() {
        return of(SoccerParameter::leagueValue);
    }

    /** {@return the beginners' profile: a small pitch, automatic kick-off, no fouls, no beam noise} */
    public static SoccerParameters beginner() {
        return of(SoccerParameter::beginnerValue);
    }

    private static SoccerParameters of(ToDoubleFunction<SoccerParameter> value) {
        return new SoccerParameters(
                Arrays.stream(SoccerParameter.values()).mapToDouble(value).toArray());
    }

    /**
     * Returns a numeric value.
     *
     * @param parameter the parameter
     * @return the value in the parameter's unit
     */
    public double get(SoccerParameter parameter) {
        return values[parameter.ordinal()];
    }

    /**
     * Returns a boolean value.
     *
     * @param parameter the parameter
     * @return whether it is true
     */
    public boolean isOn(SoccerParameter parameter) {
        return values[parameter.ordinal()] != 0;
    }

    /**
     * Returns a copy in which one parameter is set to the given value.
     *
     * @param parameter the parameter
     * @param value the new value; 1 for true and 0 for false
     * @return the changed parameters
     */
    public SoccerParameters with(SoccerParameter parameter, double value) {
        double[] changed = values.clone();
        changed[parameter.ordinal()] = value;
        return new SoccerParameters(changed);
    }

    /**
     * Returns a copy in which one parameter is set by an assignment from the command line.
     *
     * @param assignment an assignment such as {@code RuleHalfTime=60} or {@code UseCharging=false}
     * @return the changed parameters
     * @throws IllegalArgumentException if the parameter does not exist or the value is invalid; the message contains the expected format
     */
    public SoccerParameters with(String assignment) {
        int equals = assignment.indexOf('=');
        if (equals < 1) {
            throw new IllegalArgumentException(
                    "Setting \"" + assignment + "\" has no value. Write NAME=VALUE, for example RuleHalfTime=60.");
        }
        String name = assignment.substring(0, equals).trim();
        SoccerParameter parameter = SoccerParameter.ofSimSparkName(name).orElseThrow(() -> unknown(name));
        return with(parameter, parse(parameter, assignment.substring(equals + 1).trim()));
    }

    /** {@return the pitch that these parameters describe} */
    public SoccerField field() {
        return new SoccerField(
                get(SoccerParameter.FIELD_LENGTH),
                get(SoccerParameter.FIELD_WIDTH),
                get(SoccerParameter.GOAL_WIDTH),
                get(SoccerParameter.GOAL_DEPTH),
                get(SoccerParameter.GOAL_HEIGHT),
                get(SoccerParameter.PENALTY_LENGTH),
                get(SoccerParameter.PENALTY_WIDTH),
                get(SoccerParameter.FREE_KICK_DISTANCE));
    }

    /**
     * Returns all values in the format of {@link #with(String)}.
     *
     * @return one assignment per parameter, in declaration order
     */
    public List<String> assignments() {
        List<String> assignments = new ArrayList<>();
        for (SoccerParameter parameter : SoccerParameter.values()) {
            assignments.add(parameter.simSparkName() + "=" + text(parameter, get(parameter)));
        }
        return assignments;
    }

    /** {@return one line of help per parameter: name, league value, beginners' value, description} */
    public static List<String> describe() {
        return Arrays.stream(SoccerParameter.values())
                .map(parameter -> String.format(
                        Locale.ROOT,
                        "%-30s %8s %8s  %s",
                        parameter.simSparkName(),
                        text(parameter, parameter.leagueValue()),
                        text(parameter, parameter.beginnerValue()),
                        parameter.description()))
                .toList();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SoccerParameters parameters && Arrays.equals(values, parameters.values);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(values);
    }

    @Override
    public String toString() {
        return String.join(" ", assignments());
    }

    private static double parse(SoccerParameter parameter, String text) {
        if (parameter.isBoolean()) {
            return switch (text) {
                case "true" -> 1;
                case "false" -> 0;
                default ->
                    throw new IllegalArgumentException("Value \"" + text + "\" of " + parameter.simSparkName()
                            + " is neither true nor false. Write true or false.");
            };
        }
        try {
            double value = Double.parseDouble(text);
            if (Double.isFinite(value)) {
                checkSize(parameter, value);
                return value;
            }
        } catch (NumberFormatException e) {
            // Reported below, as are values that are not finite.
        }
        throw new IllegalArgumentException("Value \"" + text + "\" of " + parameter.simSparkName()
                + " is not a number. Write, for example, " + parameter.simSparkName() + "="
                + text(parameter, parameter.leagueValue()) + " (" + parameter.description() + ").");
    }

    private static void checkSize(SoccerParameter parameter, double value) {
        boolean mustBePositive = POSITIVE.contains(parameter);
        if (mustBePositive ? value <= 0 : value < 0 && !ANY_SIGN.contains(parameter)) {
            throw new IllegalArgumentException("Value " + text(parameter, value) + " of " + parameter.simSparkName()
                    + " is too small. It must be " + (mustBePositive ? "greater than 0." : "at least 0."));
        }
    }

    private static String text(SoccerParameter parameter, double value) {
        if (parameter.isBoolean()) {
            return value == 0 ? "false" : "true";
        }
        return value == PortableMath.rint(value) && Math.abs(value) < 1e15
                ? Long.toString((long) value)
                : Double.toString(value);
    }

    private static IllegalArgumentException unknown(String name) {
        return new IllegalArgumentException("Parameter \"" + name + "\" does not exist."
                + SoccerParameter.question(name) + " \"robonewbie simulator --help\" lists all of them.");
    }
}
