package org.robonewbie.protocol.monitor;

import org.robonewbie.nao.TeamSide;

/**
 * Names one robot of a match.
 *
 * @param side its team
 * @param number the number on its chest, 1 to 11
 */
public record PlayerNumber(TeamSide side, int number) {}
