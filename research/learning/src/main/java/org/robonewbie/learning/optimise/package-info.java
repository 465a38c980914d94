/**
 * Optimisation of an existing motion, the walk engine or the tunable numbers of an agent. Read {@link
 * org.robonewbie.learning.optimise.Optimisation} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.optimise;
