package org.robonewbie.protocol.order;

import org.robonewbie.nao.TeamSide;

/**
 * Identifier of a robot in a match.
 *
 * @param side the robot's team
 * @param number shirt number, 1 to 11
 */
public record PlayerNumber(TeamSide side, int number) {}
