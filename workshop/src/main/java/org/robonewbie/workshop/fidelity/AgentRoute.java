package org.robonewbie.workshop.fidelity;

/** Transport between a recording and the replaying robot. */
public enum AgentRoute {
    /** Direct access to the world, without a server or messages. */
    NONE,
    /** A full server with its rules, and an agent in the same process. */
    IN_PROCESS,
    /** A full server with its rules, and an agent connected over TCP. */
    TCP
}
