/**
 * World states that can be kept in memory or in a file and restored bit-identically, and the random sources that belong to
 * them. Read {@link org.robonewbie.simulator.state.WorldState} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.state;
