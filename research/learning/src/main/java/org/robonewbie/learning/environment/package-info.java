/**
 * Environments for reinforcement learning, their tasks, and a server that training programs in other languages connect to. Read {@link
 * org.robonewbie.learning.environment.TrainingTask} first, then {@link org.robonewbie.learning.environment.EnvironmentSpec}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.environment;
