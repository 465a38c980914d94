package org.robonewbie.simulator.world;

import org.robonewbie.nao.Vector3;

/**
 * Two robots touch.
 *
 * @param first a part of one robot
 * @param second a part of another robot
 * @param position where, in the world frame, metres
 */
public record RobotContact(RobotPart first, RobotPart second, Vector3 position) {}
