package org.robonewbie.workshop.fidelity;

/** On which way the commands of a recording reach the robot, and its measurements come back. */
public enum AgentRoute {
    /** Straight into the world and out of it, without server and messages. */
    NONE,
    /** Through a whole server with its rules, to which the agent is connected within the process. */
    IN_PROCESS,
    /** Through a whole server with its rules, to which the agent is connected by a TCP socket. */
    TCP
}
