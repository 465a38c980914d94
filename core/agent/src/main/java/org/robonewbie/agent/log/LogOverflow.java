package org.robonewbie.agent.log;

import java.util.List;

/** The place for the oldest lines of a log that has become too long for the memory. */
public interface LogOverflow {

    /**
     * Takes the oldest lines of the log.
     *
     * @param oldest the lines, oldest first
     */
    void take(List<LogLine> oldest);

    /**
     * Ends the log.
     *
     * @return a line that says where the lines are; empty if there were none
     */
    String closingNote();
}
