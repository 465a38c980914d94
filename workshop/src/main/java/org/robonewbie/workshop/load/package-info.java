/**
 * Load test of a server with complete matches over TCP: whether it keeps up with real time, and at what cost. Start
 * with {@link org.robonewbie.workshop.load.MatchLoad}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.load;
