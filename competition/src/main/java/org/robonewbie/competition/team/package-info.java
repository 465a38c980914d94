/**
 * The programs that take part: how they are named, prepared and started, each in a process of its own. Start reading with {@link org.robonewbie.competition.team.TeamList}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.team;
