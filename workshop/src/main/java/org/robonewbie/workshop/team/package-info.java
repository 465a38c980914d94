/**
 * Statistics on games played by the example agents and the example team. Start with {@link
 * org.robonewbie.workshop.team.TeamMeasurement}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.team;
