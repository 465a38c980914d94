package org.robonewbie.protocol.monitor;

import org.robonewbie.protocol.order.PlayerNumber;

/**
 * A foul called by the referee.
 *
 * @param index one-based index of the foul in the match
 * @param type type of the foul
 * @param player the offending robot
 */
public record Foul(int index, FoulType type, PlayerNumber player) {}
