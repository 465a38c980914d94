/**
 * The programs that take part: how they are named, prepared and started, each in a separate process. Start reading with {@link org.robonewbie.competition.team.TeamList}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.team;
