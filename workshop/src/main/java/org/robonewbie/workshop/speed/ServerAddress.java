package org.robonewbie.workshop.speed;

import java.util.OptionalLong;

/**
 * Where another server is.
 *
 * @param host name or address of its computer
 * @param agentPort TCP port for agents
 * @param monitorPort TCP port for monitors and trainers
 * @param processId its process on this computer, whose processor time is measured; empty for none
 */
public record ServerAddress(String host, int agentPort, int monitorPort, OptionalLong processId) {}
