/**
 * Programs of the teams: listing, preparing and starting them in child processes. Start with {@link
 * org.robonewbie.competition.team.TeamList}.
 *
 * <p><strong>Internal</strong>: not part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.team;
