/** Tests of what is done to ode4j. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.physics.ode;
