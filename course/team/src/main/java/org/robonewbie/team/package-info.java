/**
 * The example team for the league's pitch. Read {@link org.robonewbie.team.Agent_Team} first, then {@link
 * org.robonewbie.team.tactics.Strategy}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team;
