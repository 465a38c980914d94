/**
 * What a player decides: its role, its place, and what to do with the ball. Read {@link org.robonewbie.team.tactics.Strategy} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team.tactics;
