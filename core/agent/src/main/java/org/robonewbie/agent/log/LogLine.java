package org.robonewbie.agent.log;

import java.util.Locale;

/**
 * One entry of the log.
 *
 * @param seconds simulated time in seconds at which it was written
 * @param level how important it is
 * @param text what it says, possibly several lines
 */
public record LogLine(double seconds, LogLevel level, String text) {

    /**
     * Returns the entry as it is printed; further lines of the text are indented.
     *
     * @return such as {@code   12.34  INFO     ball at 1.20 m}
     */
    @Override
    public String toString() {
        String indented = text.replace("\n", "\n" + " ".repeat(19));
        return String.format(Locale.ROOT, "%8.2f  %-7s  %s", seconds, level, indented);
    }
}
