package org.robonewbie.protocol.order;

import org.robonewbie.nao.TeamSide;

/**
 * Identifies a robot of a match.
 *
 * @param side its team
 * @param number its shirt number, 1 to 11
 */
public record PlayerNumber(TeamSide side, int number) {}
