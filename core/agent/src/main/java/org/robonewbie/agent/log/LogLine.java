package org.robonewbie.agent.log;

import java.util.Locale;

/**
 * Log entry.
 *
 * @param seconds simulated time in seconds
 * @param level severity
 * @param text message, possibly several lines
 */
public record LogLine(double seconds, LogLevel level, String text) {

    /**
     * Returns the printed form; all lines of the text after the first are indented.
     *
     * @return the text to print, such as {@code   12.34  INFO     ball at 1.20 m}
     */
    @Override
    public String toString() {
        String indented = text.replace("\n", "\n" + " ".repeat(19));
        return String.format(Locale.ROOT, "%8.2f  %-7s  %s", seconds, level, indented);
    }
}
