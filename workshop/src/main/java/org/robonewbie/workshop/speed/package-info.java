/**
 * Benchmark of a complete server with robots that stand, walk or lie in a pile. Start with {@link
 * org.robonewbie.workshop.speed.Benchmark}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.speed;
