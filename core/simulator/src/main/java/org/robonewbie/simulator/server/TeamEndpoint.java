package org.robonewbie.simulator.server;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * A listening socket for the agents of one team. Their robots join this team regardless of the name they request, so
 * that no program can play for another team.
 *
 * @param team the team
 * @param robots maximum number of the team's agents that count as awaited agents
 * @param file path of the Unix domain socket to listen on; empty for any free TCP port on 127.0.0.1
 * @param admission accepts or refuses a client of the TCP port by its address; called on the simulation thread
 */
public record TeamEndpoint(String team, int robots, Optional<Path> file, Predicate<InetSocketAddress> admission) {}
