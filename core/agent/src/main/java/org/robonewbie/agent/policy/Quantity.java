package org.robonewbie.agent.policy;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.Joint;

/**
 * An input or output of a policy.
 *
 * @param name name of the quantity, such as {@code gyro.forward}, or {@code gyro.forward@-2} for its value two actions ago
 * @param unit unit of measurement, such as {@code degrees/s}, optionally with a factor, as in {@code 10 degrees}; {@code 1} if
 *     dimensionless
 */
public record Quantity(String name, String unit) {

    private static final String AGO = "@-";
    private static final Pattern FACTOR = Pattern.compile("(\\d+(?:\\.\\d+)?)(?: .*)?");

    /**
     * Returns a quantity whose unit has a factor.
     *
     * @param name name of the quantity
     * @param factor factor of the unit
     * @param unit unit of measurement
     * @return the quantity, such as one in {@code 10 degrees}
     */
    public static Quantity scaled(String name, double factor, String unit) {
        return new Quantity(
                name, (factor == (long) factor ? Long.toString((long) factor) : Double.toString(factor)) + " " + unit);
    }

    /** {@return the factor of the unit, such as 10 for {@code 10 degrees}; 1 for a unit without a factor} */
    public double factor() {
        Matcher number = FACTOR.matcher(unit);
        return number.matches() ? Double.parseDouble(number.group(1)) : 1;
    }

    /**
     * Returns the output that is the speed of a joint.
     *
     * @param joint the joint
     * @return the output; its unit is the joint's highest speed
     */
    public static Quantity speedOf(Joint joint) {
        return new Quantity(
                "speed." + joint, String.format(Locale.ROOT, "%.2f degrees/s", joint.maxDegreesPerSecond()));
    }

    /**
     * Returns the same quantity at the time of an earlier action.
     *
     * @param actions number of actions since then, at least 1
     * @return the earlier value
     */
    public Quantity ago(int actions) {
        return new Quantity(name + AGO + actions, unit);
    }

    /** {@return the number of actions since the time of this quantity; 0 for a current one} */
    public int age() {
        int at = name.indexOf(AGO);
        return at < 0 ? 0 : Integer.parseInt(name.substring(at + AGO.length()));
    }

    /** {@return the same quantity at the time of the current action} */
    public Quantity current() {
        int at = name.indexOf(AGO);
        return at < 0 ? this : new Quantity(name.substring(0, at), unit);
    }
}
