package org.robonewbie.agent.log;

/** Severity of a log line, in ascending order. */
public enum LogLevel {
    /** Details for debugging. */
    DEBUG,
    /** Normal events. */
    INFO,
    /** Something unexpected; the robot continues. */
    WARNING,
    /** An error; the robot continues as well as it can. */
    ERROR
}
