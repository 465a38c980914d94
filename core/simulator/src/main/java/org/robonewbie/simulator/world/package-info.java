/**
 * Physical model of the pitch, ball and robots: motion, contacts, inertial sensors and force sensors. Read {@link
 * org.robonewbie.simulator.world.SoccerWorld} first.
 *
 * <p>All quantities are in SimSpark's frames. In the world frame, x points towards the right goal, y to the left of
 * that direction, z up. In the frame of a robot's link, x points to the right, y forward, z up.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.world;
