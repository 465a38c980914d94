package org.robonewbie.agent.log;

import java.util.regex.Pattern;

/** Removes the minus sign from rounded zeros in text, such as {@code -0.00 m} for a very small negative number. */
public final class NegativeZeroFormat {

    private static final Pattern PATTERN = Pattern.compile("(?<![\\w.])-(0(?:\\.0+)?)(?![.\\w])");

    private NegativeZeroFormat() {}

    /**
     * Removes the minus sign from all zeros.
     *
     * @param text text that contains numbers
     * @return the text with {@code 0.00} for {@code -0.00}
     */
    public static String removed(String text) {
        return text.contains("-0") ? PATTERN.matcher(text).replaceAll("$1") : text;
    }
}
