/**
 * Robots of the RoboCup 3D league since 2026, played by programs that were written for the NAO. <b>Internal</b>: programs use it by the
 * option {@code --robot}.
 *
 * <p>{@link org.robonewbie.agent.league.LeaguePort} exchanges the messages with the server, {@link
 * org.robonewbie.agent.league.LeagueMotors} moves arms and head as the program asks, and the legs stand by themselves.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.league;
