package org.robonewbie.agent;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoublePredicate;
import java.util.function.Predicate;
import org.robonewbie.nao.math.PortableMath;

/**
 * Valid values of an option.
 *
 * @param expected description of the valid values, for messages
 * @param condition predicate that accepts the valid values
 */
record Values(String expected, Predicate<String> condition) {

    static final Values TEXT = new Values("a text", value -> !value.isBlank());

    static final Values NAME = new Values(
            "a name of letters A to Z, digits and symbols, without spaces, brackets or quotes",
            value -> !value.isEmpty() && value.chars().allMatch(c -> c > ' ' && c <= '~' && "()\"';".indexOf(c) < 0));

    static final Values FLAG = new Values("true or false", value -> value.equals("true") || value.equals("false"));

    static final Values LONG = new Values("a whole number", Values::isLong);

    static final Values POSITIVE = new Values("a number above 0", value -> isNumber(value, number -> number > 0));

    static final Values POSE = new Values("three numbers X,Y,DEGREES such as -0.5,0.4,-40", Values::isPose);

    static Values oneOf(String... words) {
        return new Values("one of " + String.join(", ", words), List.of(words)::contains);
    }

    static Values wholeNumber(int least, int most) {
        return new Values(
                "a whole number from " + least + " to " + most,
                value -> isNumber(
                        value, number -> number >= least && number <= most && number == PortableMath.rint(number)));
    }

    private static boolean isPose(String value) {
        String[] parts = value.split(",", -1);
        return parts.length == 3 && Arrays.stream(parts).map(String::trim).allMatch(Values::isNumber);
    }

    private static boolean isLong(String value) {
        try {
            Long.parseLong(value);
            return true;
        } catch (NumberFormatException notANumber) {
            return false;
        }
    }

    static boolean isNumber(String value) {
        return isNumber(value, number -> true);
    }

    private static boolean isNumber(String value, DoublePredicate condition) {
        try {
            double number = Double.parseDouble(value);
            return Double.isFinite(number) && condition.test(number);
        } catch (NumberFormatException notANumber) {
            return false;
        }
    }
}
