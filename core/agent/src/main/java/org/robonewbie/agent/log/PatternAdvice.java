package org.robonewbie.agent.log;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Diagnosis of a {@link String#format} pattern that does not match its values, as a sentence that suggests what to write instead. */
final class PatternAdvice {

    private static final Pattern SPECIFIER = Pattern.compile("%(\\d+\\$|<)?([-#+ 0,(]*)\\d*(\\.\\d+)?([a-zA-Z%])?");
    private static final int INDEX = 1;
    private static final int FLAGS = 2;
    private static final int PRECISION = 3;
    private static final int CONVERSION = 4;

    private static final String WHOLE = "doxX";
    private static final String REAL = "eEfgGaA";
    private static final String ANY = "bBhHsScCtT";
    private static final String WITHOUT_VALUE = "n%";
    private static final String PER_CENT = "%% writes a per cent sign";
    private static final int MAX_CHARACTERS = 40;

    private final String pattern;
    private final Object[] values;
    private int next;

    private PatternAdvice(String pattern, Object[] values) {
        this.pattern = pattern;
        this.values = values;
    }

    /**
     * Returns whether the pattern has fewer per cent signs than there are values, so some values are not shown.
     */
    static boolean leavesValuesOut(String pattern, Object[] values) {
        return pattern.chars().filter(letter -> letter == '%').count() < values.length;
    }

    /**
     * Describes the first error in a pattern.
     *
     * @param pattern a pattern that does not match its values
     * @param values its values
     * @return a sentence
     */
    static String of(String pattern, Object[] values) {
        PatternAdvice advice = new PatternAdvice(pattern, values);
        for (Matcher specifier = SPECIFIER.matcher(pattern); specifier.find(); ) {
            String problem = advice.problemOf(specifier);
            if (!problem.isEmpty()) {
                return problem + ", in " + quoted(pattern) + ".";
            }
        }
        return leavesValuesOut(pattern, values)
                ? "The text " + quoted(pattern)
                        + " lacks placeholders: write %.1f or %s where each value should appear."
                : "The values do not match " + quoted(pattern) + "; " + PER_CENT + ".";
    }

    /** Describes the error in one format specifier; empty if it is valid. */
    private String problemOf(Matcher specifier) {
        String conversion = String.valueOf(specifier.group(CONVERSION));
        if (isLone(specifier)) {
            return "A lone % shows nothing; " + PER_CENT;
        }
        if (WITHOUT_VALUE.contains(conversion)) {
            return "";
        }
        if (!(WHOLE + REAL + ANY).contains(conversion)) {
            return specifier.group() + " is unknown: %d is for whole numbers, %.1f for other numbers, %s for texts; "
                    + PER_CENT;
        }
        int position = position(specifier.group(INDEX));
        if (position < 0 || position >= values.length) {
            return "There is no value for " + specifier.group() + ": pass one more value, or remove the"
                    + " placeholder; " + PER_CENT;
        }
        return mismatch(specifier, conversion, values[position]);
    }

    private int position(String index) {
        if (index == null) {
            return next++;
        }
        return index.equals("<") ? next - 1 : Integer.parseInt(index.substring(0, index.length() - 1)) - 1;
    }

    private static String mismatch(Matcher specifier, String conversion, Object value) {
        boolean whole = value instanceof Number && !(value instanceof Double) && !(value instanceof Float);
        boolean real = value instanceof Double || value instanceof Float;
        boolean precise = specifier.group(PRECISION) != null;
        String better = whole ? "%d" : real ? "%.1f" : "%s";
        if (WHOLE.contains(conversion) && value != null && (!whole || precise)) {
            return specifier.group() + (whole ? " has no digits after the point" : " is for whole numbers") + "; use "
                    + better + " for " + quotedValue(value);
        }
        if (REAL.contains(conversion) && value != null && !real) {
            return specifier.group() + " is for decimal numbers; use " + better + " for " + quotedValue(value);
        }
        if (conversion.equalsIgnoreCase("c") && value != null && !(value instanceof Character)) {
            return specifier.group() + " is for one letter; use " + better + " for " + quotedValue(value);
        }
        return "";
    }

    /**
     * Returns whether a per cent sign stands alone and does not begin a format specifier, as in
     * {@code 50 % of the way}.
     */
    private boolean isLone(Matcher specifier) {
        int end = specifier.end();
        boolean blank = specifier.group(FLAGS).contains(" ");
        boolean wordFollows = end < pattern.length() && Character.isLetter(pattern.charAt(end));
        String conversion = specifier.group(CONVERSION);
        return conversion == null || (blank && (wordFollows || !(WHOLE + REAL).contains(conversion)));
    }

    private static String quotedValue(Object value) {
        return value instanceof Number ? NegativeZeroFormat.removed(value.toString()) : quoted(String.valueOf(value));
    }

    private static String quoted(String text) {
        return "\"" + (text.length() > MAX_CHARACTERS ? text.substring(0, MAX_CHARACTERS) + "…" : text) + "\"";
    }
}
