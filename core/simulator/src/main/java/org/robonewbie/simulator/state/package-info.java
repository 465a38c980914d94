/**
 * What a world is at one moment, as a value: kept in memory, written to a file, and gone on from to the bit. Read {@link
 * org.robonewbie.simulator.state.WorldState} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.state;
