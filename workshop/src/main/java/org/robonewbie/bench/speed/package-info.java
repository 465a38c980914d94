/**
 * How fast a whole server is with robots that stand, walk or lie in a heap. Read {@link
 * org.robonewbie.bench.speed.Benchmark} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.bench.speed;
