package org.robonewbie.agent.log;

import java.util.List;

/** Storage for the oldest lines of a log that has outgrown its buffer. */
public interface LogOverflow {

    /**
     * Stores the oldest lines of the log.
     *
     * @param oldest the lines, oldest first
     */
    void take(List<LogLine> oldest);

    /**
     * Stops storing lines.
     *
     * @return a log line with the location of the stored lines; empty if there are none
     */
    String closingNote();
}
