/**
 * A walk into any direction, calculated cycle by cycle: for those who want to see how walking works. Read {@link
 * org.robonewbie.agent.walk.Walk} first, then {@link org.robonewbie.agent.walk.WalkEngine}, which explains the plan and names
 * its sources, and then {@link org.robonewbie.agent.walk.Step} with the curves of a step.
 *
 * <p>Words: the <em>support foot</em> carries the robot while the <em>swing foot</em> moves; the <em>step phase</em> goes from 0
 * to 1 in one step; the <em>double support</em> is the part of it in which both feet are on the ground; the torso
 * <em>sways</em> over the support foot. Forward is x, to the left y, up z.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.walk;
