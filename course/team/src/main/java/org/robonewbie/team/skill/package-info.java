/**
 * What a player can do: walk around others, bring the ball forward, kick, keep the goal. Read {@link org.robonewbie.team.skill.Dribble} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team.skill;
