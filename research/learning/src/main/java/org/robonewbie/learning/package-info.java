/**
 * Improvement of what robots do: environments and policies, search, data sets and experiments. Read {@link
 * org.robonewbie.learning.optimise.Optimisation} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning;
