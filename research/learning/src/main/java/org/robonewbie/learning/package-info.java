/**
 * Machine learning and experiments with simulated robots. The module has five parts: environments for reinforcement learning with a
 * server for Python ({@link org.robonewbie.learning.environment.TrainingTask}), direct policy search by evolution strategies ({@link
 * org.robonewbie.learning.policy.PolicySearch}), optimisation of motions, the walk engine and agents by CMA-ES ({@link
 * org.robonewbie.learning.optimise.Optimisation}), planned series of trials ({@link org.robonewbie.learning.series.Experiment}), and data
 * sets of recorded runs ({@link org.robonewbie.learning.dataset.DataSet}). Read {@link
 * org.robonewbie.learning.environment.TrainingTask} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning;
