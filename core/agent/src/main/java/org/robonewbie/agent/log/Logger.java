package org.robonewbie.agent.log;

import java.util.List;

/**
 * A robot's log. Lines are collected and printed when the run is over, because printing within a cycle may delay it;
 * the studio shows them immediately. No line is lost when the program or the server fails. Thread-safe.
 *
 * <pre>{@code
 * log.info("ball at %.2f m", fieldView.ball().distance());
 * }</pre>
 *
 * <p>With values, the text is a format pattern as in {@link String#format}; without values, it is logged literally.
 */
public interface Logger {

    /**
     * Sets the threshold of the log, initially {@link LogLevel#INFO}.
     *
     * @param level lines below it are dropped
     */
    void setLevel(LogLevel level);

    /**
     * Logs a detail for debugging.
     *
     * @param format text or format pattern
     * @param values values to insert into the pattern
     */
    void debug(String format, Object... values);

    /**
     * Logs a normal event.
     *
     * @param format text or format pattern
     * @param values values to insert into the pattern
     */
    void info(String format, Object... values);

    /**
     * Logs something unexpected.
     *
     * @param format text or format pattern
     * @param values values to insert into the pattern
     */
    void warning(String format, Object... values);

    /**
     * Logs an error.
     *
     * @param format text or format pattern
     * @param values values to insert into the pattern
     */
    void error(String format, Object... values);

    /** {@return the lines in memory, oldest first} */
    List<LogLine> lines();
}
