/**
 * How fast a whole server is with robots that stand, walk or lie in a heap. Read {@link
 * org.robonewbie.workshop.speed.Benchmark} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.speed;
