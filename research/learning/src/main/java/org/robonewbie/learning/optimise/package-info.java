/**
 * Improves what there is already: a motion, the walk engine or the numbers of an agent gets better at an objective, from one
 * command. Read {@link org.robonewbie.learning.optimise.Optimisation} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.optimise;
