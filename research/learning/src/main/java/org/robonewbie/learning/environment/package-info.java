/**
 * Environments for reinforcement learning, their tasks, and a server for training programs in other languages. Read {@link
 * org.robonewbie.learning.environment.TrainingTask} first, then {@link org.robonewbie.learning.environment.EnvironmentSpec}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.environment;
