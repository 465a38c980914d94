package org.robonewbie.workshop.fidelity;

/** Transport between a recording and the replaying robot. */
public enum AgentRoute {
    /** Direct access to the world, without server and messages. */
    NONE,
    /** A whole server with its rules, and an agent in the same process. */
    IN_PROCESS,
    /** A whole server with its rules, and an agent connected over TCP. */
    TCP
}
