/**
 * What a robot can be good at, as small functions over the true state of the world. Read {@link
 * org.robonewbie.learning.objective.Objective} first, then {@link org.robonewbie.learning.objective.StandardObjective}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.objective;
