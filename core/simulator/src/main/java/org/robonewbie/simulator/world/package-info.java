/**
 * Physical model of the pitch, ball and robots: motion, contacts, inertial sensors and force sensors. Read {@link
 * org.robonewbie.simulator.world.SoccerWorld} first.
 *
 * <p>All quantities are in SimSpark's frames. The world has x towards the right goal, y to its left, z up. The links of a robot
 * have x to the right, y forward, z up.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.world;
