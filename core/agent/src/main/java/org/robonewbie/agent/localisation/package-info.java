/**
 * Estimation of the robot's movement, its pose on the field, and the current positions of objects that it has seen. No
 * other part of the framework depends on this package. Read {@link org.robonewbie.agent.localisation.SelfLocalisation}
 * first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.localisation;
