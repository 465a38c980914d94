/**
 * Collision detection by ode4j, the Java port of the Open Dynamics Engine that SimSpark uses. No other package imports ode4j.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.physics.ode;
