/**
 * Soccer match: parameters, state, and the automatic referee with one class per rule. Read {@link
 * org.robonewbie.simulator.soccer.Match} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.soccer;
