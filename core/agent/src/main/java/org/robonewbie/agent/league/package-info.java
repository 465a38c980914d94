/**
 * Robots of the RoboCup 3D league since 2026, played by programs that were written for the NAO.
 *
 * <p>{@link org.robonewbie.agent.league.LeaguePort} exchanges the messages with the server; arms and head move as the program asks, and
 * the legs stand or walk by themselves.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.league;
