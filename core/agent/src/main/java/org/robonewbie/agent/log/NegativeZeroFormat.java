package org.robonewbie.agent.log;

import java.util.regex.Pattern;

/** Takes the sign from a zero in a text: {@code -0.00 m} is a small negative number that was rounded. */
public final class NegativeZeroFormat {

    private static final Pattern PATTERN = Pattern.compile("(?<![\\w.])-(0(?:\\.0+)?)(?![.\\w])");

    private NegativeZeroFormat() {}

    /**
     * Removes the sign of all zeros.
     *
     * @param text a text with numbers
     * @return the same with {@code 0.00} for {@code -0.00}
     */
    public static String removed(String text) {
        return text.contains("-0") ? PATTERN.matcher(text).replaceAll("$1") : text;
    }
}
