package org.robonewbie.workshop.fidelity;

/**
 * Where a server runs.
 *
 * @param host name or address of its computer
 * @param port its port for agents, usually 3100
 * @param monitorPort its port for monitors, usually 3200
 */
public record ReferenceServer(String host, int port, int monitorPort) {}
