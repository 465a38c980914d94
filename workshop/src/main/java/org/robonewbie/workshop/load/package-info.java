/**
 * Puts a server under the load of whole matches over TCP and measures whether it keeps up with the clock, and at what cost.
 * Read {@link org.robonewbie.workshop.load.MatchLoad} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.load;
