/**
 * Decisions of a player: its role, its position, and what to do with the ball. Read {@link
 * org.robonewbie.team.tactics.Strategy} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team.tactics;
