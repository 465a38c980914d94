/**
 * The game: its settings, its state and the automatic referee, which knows one small class for each rule. Read {@link
 * org.robonewbie.simulator.soccer.Match} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.soccer;
