package org.robonewbie.simulator.world;

import org.robonewbie.nao.Vector3;

/**
 * Contact point between two robots.
 *
 * @param first part of one robot
 * @param second part of another robot
 * @param position position in the world frame in metres
 */
public record RobotContact(RobotPart first, RobotPart second, Vector3 position) {}
