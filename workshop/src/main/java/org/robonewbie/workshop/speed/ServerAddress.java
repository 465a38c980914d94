package org.robonewbie.workshop.speed;

import java.util.OptionalLong;

/**
 * Address of a server in another process.
 *
 * @param host host name or IP address
 * @param agentPort TCP port for agents
 * @param monitorPort TCP port for monitors and trainers
 * @param processId local process whose processor time is measured; empty if unknown
 */
public record ServerAddress(String host, int agentPort, int monitorPort, OptionalLong processId) {}
