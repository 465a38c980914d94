package org.robonewbie.protocol.monitor;

import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.robot.RobotState;

/**
 * A robot in an RSMP scene.
 *
 * @param player the robot's team and number
 * @param state pose of its torso and angles of its joints
 */
public record RsmpRobot(PlayerNumber player, RobotState state) {}
