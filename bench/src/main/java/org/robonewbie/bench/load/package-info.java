/**
 * Puts a server under the load of whole matches over TCP and measures whether it keeps up with the clock, and at what cost.
 * Read {@link org.robonewbie.bench.load.MatchLoad} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.bench.load;
