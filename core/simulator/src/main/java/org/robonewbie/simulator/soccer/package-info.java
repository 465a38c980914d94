/**
 * The game: its settings, its state and the automatic referee, which knows one small class for each rule. Read {@link
 * org.robonewbie.simulator.soccer.Match} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.soccer;
