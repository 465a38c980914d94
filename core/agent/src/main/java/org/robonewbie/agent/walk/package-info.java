/**
 * An omnidirectional walk that is computed cycle by cycle. Read {@link org.robonewbie.agent.walk.Walk} first, then {@link
 * org.robonewbie.agent.walk.WalkEngine}, whose documentation explains the method and cites its sources, and then {@link
 * org.robonewbie.agent.walk.Step} with the trajectories of a step.
 *
 * <p>Terms: the <em>support foot</em> carries the robot while the <em>swing foot</em> moves; the <em>step phase</em> runs from
 * 0 to 1 in one step; the <em>double support</em> is the fraction of a step in which both feet are on the ground; the
 * torso <em>sways</em> over the support foot. x is forward, y left, z up.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.walk;
