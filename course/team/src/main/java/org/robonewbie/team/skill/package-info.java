/**
 * Skills of a player: path following, dribbling, kicking, goalkeeping. Read {@link org.robonewbie.team.skill.Dribble} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team.skill;
