package org.robonewbie.workshop.fidelity;

/**
 * Address of a server.
 *
 * @param host host name or IP address
 * @param port TCP port for agents, usually 3100
 * @param monitorPort TCP port for monitors, usually 3200
 */
public record ReferenceServer(String host, int port, int monitorPort) {}
