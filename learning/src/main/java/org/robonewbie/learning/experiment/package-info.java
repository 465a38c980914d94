/**
 * Experiments with robots in worlds of their own: begin with a seed, step, look at the truth, begin again; without server,
 * sockets and clock. Read {@link org.robonewbie.learning.experiment.Trial} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.experiment;
