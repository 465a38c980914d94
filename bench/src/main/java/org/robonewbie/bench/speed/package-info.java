/**
 * How fast a whole server is with robots that stand, walk or lie in a heap. Read {@link
 * org.robonewbie.bench.speed.Benchmark} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.bench.speed;
