package org.robonewbie.agent.log;

/** How important a line of the log is, from the least to the most important. */
public enum LogLevel {
    /** Details for debugging. */
    DEBUG,
    /** What happens. */
    INFO,
    /** Something is odd; the robot continues. */
    WARNING,
    /** Something is wrong; the robot continues as well as it can. */
    ERROR
}
