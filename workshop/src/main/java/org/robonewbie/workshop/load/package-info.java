/**
 * Load tests over TCP: whether a server keeps up with real time in complete matches, at what cost, and how much processor time the examples
 * need. Start with {@link org.robonewbie.workshop.load.MatchLoad} and {@link org.robonewbie.workshop.load.ExampleLoad}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.load;
