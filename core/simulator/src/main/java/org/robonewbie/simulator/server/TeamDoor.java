package org.robonewbie.simulator.server;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * An entrance for the programs of one team alone. Whatever name an agent gives itself, its robot belongs to this team; so no
 * program can play, or foul, under the name of another one.
 *
 * @param team the team
 * @param robots how many agents of the team count when the world waits for all before it begins
 * @param file file of a Unix domain socket at which to listen; empty for any free TCP port of 127.0.0.1
 * @param welcome decides, from the other end's address, who may come in through a TCP port; called on the simulation's thread
 */
public record TeamDoor(String team, int robots, Optional<Path> file, Predicate<InetSocketAddress> welcome) {}
