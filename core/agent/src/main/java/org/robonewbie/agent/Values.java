package org.robonewbie.agent;

import java.util.Optional;
import java.util.function.DoublePredicate;
import org.robonewbie.nao.math.PortableMath;

/** Checks of option values; each says in half a sentence what was expected. */
final class Values {

    private Values() {}

    /** What is wrong with a value; empty if nothing is. */
    @FunctionalInterface
    interface Check {
        Optional<String> complaint(String value);
    }

    static Optional<String> text(String value) {
        return expect(!value.isBlank(), "a text");
    }

    static Optional<String> name(String value) {
        boolean readable =
                !value.isEmpty() && value.chars().allMatch(c -> c > ' ' && c <= '~' && "()\"';".indexOf(c) < 0);
        return expect(readable, "a name of letters A to Z, digits and signs without blanks, brackets and quotes");
    }

    static Optional<String> flag(String value) {
        return expect(value.equals("true") || value.equals("false"), "true or false");
    }

    static Check wholeNumber(int least, int most) {
        return value -> expect(
                isNumber(value, number -> number >= least && number <= most && number == PortableMath.rint(number)),
                "a whole number from " + least + " to " + most);
    }

    static Optional<String> longNumber(String value) {
        try {
            Long.parseLong(value);
            return Optional.empty();
        } catch (NumberFormatException notANumber) {
            return expect(false, "a whole number");
        }
    }

    static Optional<String> positive(String value) {
        return expect(isNumber(value, number -> number > 0), "a number above 0");
    }

    static Optional<String> pose(String value) {
        String[] parts = value.split(",", -1);
        boolean numbers = parts.length == 3;
        for (String part : parts) {
            numbers &= isNumber(part.trim());
        }
        return expect(numbers, "three numbers X,Y,DEGREES such as -0.5,0.4,-40");
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

    private static Optional<String> expect(boolean fulfilled, String expected) {
        return fulfilled ? Optional.empty() : Optional.of(expected);
    }
}
