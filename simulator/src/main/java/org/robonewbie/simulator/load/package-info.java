/**
 * Puts a server under the load of whole matches over TCP and measures whether it keeps step with the clock, and what that
 * costs. Read {@link org.robonewbie.simulator.load.MatchLoad} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.load;
