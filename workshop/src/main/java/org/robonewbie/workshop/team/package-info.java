/**
 * Games of the example agents and of the example team, measured. Read {@link org.robonewbie.workshop.team.TeamMeasurement} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.team;
