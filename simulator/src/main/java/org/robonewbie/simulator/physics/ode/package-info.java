/**
 * The rigid-body engine on ode4j, the Java edition of the Open Dynamics Engine that SimSpark uses. Nothing else imports
 * ode4j. Read {@link org.robonewbie.simulator.physics.ode.OdePhysicsWorld} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.physics.ode;
