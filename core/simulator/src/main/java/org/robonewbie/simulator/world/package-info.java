/**
 * The pitch with goals, ball and robots as bodies: what moves, what touches what, and what the robots' inertial and force
 * sensors feel. Read {@link org.robonewbie.simulator.world.SoccerWorld} first.
 *
 * <p>All quantities are in SimSpark's frames: the world has x towards the right goal, y to the left of it, z up; a robot's
 * links have x to the right, y forward, z up.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.world;
