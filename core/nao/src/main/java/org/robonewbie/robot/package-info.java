/**
 * Robots as data: bodies, joints, motors and shapes of the NAO and of the league's robots. Start reading at
 * {@link org.robonewbie.robot.RobotModel}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.robot;
