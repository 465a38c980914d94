package org.robonewbie.agent.log;

import java.util.List;

/**
 * A robot's log. The lines are collected and printed when the run is over, since printing within a cycle takes time that the
 * robot does not have; the studio shows them at once. Nothing is lost when the program or the server dies. Thread-safe.
 *
 * <pre>{@code
 * log.info("ball at %.2f m", fieldView.ball().distance());
 * }</pre>
 *
 * <p>A text with values is a pattern as of {@link String#format}; without values it is taken literally.
 */
public interface Logger {

    /**
     * Sets the least important level that is kept, at first {@link LogLevel#INFO}.
     *
     * @param level lines below it are dropped
     */
    void setLevel(LogLevel level);

    /**
     * Logs a detail.
     *
     * @param format text or pattern
     * @param values what the pattern shows
     */
    void debug(String format, Object... values);

    /**
     * Logs what happens.
     *
     * @param format text or pattern
     * @param values what the pattern shows
     */
    void info(String format, Object... values);

    /**
     * Logs something odd.
     *
     * @param format text or pattern
     * @param values what the pattern shows
     */
    void warning(String format, Object... values);

    /**
     * Logs something wrong.
     *
     * @param format text or pattern
     * @param values what the pattern shows
     */
    void error(String format, Object... values);

    /** {@return the lines in memory, oldest first} */
    List<LogLine> lines();
}
