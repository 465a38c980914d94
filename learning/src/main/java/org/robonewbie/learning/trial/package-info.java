/**
 * Trials of motions in the simulated world, with true measures of what happened. Read {@link
 * org.robonewbie.learning.trial.TrialRobot} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.trial;
