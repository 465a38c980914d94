/**
 * Robots as data: bodies, joints, motors and shapes of the NAO and of the league's robots. Read {@link
 * org.robonewbie.robot.RobotModel} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.robot;
