/**
 * The teams' programs: lists of teams, and the preparation and start of programs in child processes. Start with {@link
 * org.robonewbie.competition.team.TeamList}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.team;
