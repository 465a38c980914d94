package org.robonewbie.agent.log;

/** How important a line of the log is, from the least to the most important. */
public enum LogLevel {
    /** Details for the search of an error. */
    DEBUG,
    /** What happens. */
    INFO,
    /** Something is odd, the robot goes on. */
    WARNING,
    /** Something is wrong, the robot goes on as well as it can. */
    ERROR
}
