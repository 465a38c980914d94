package org.robonewbie.protocol.monitor;

import org.robonewbie.protocol.order.PlayerNumber;

/**
 * A foul called by the referee.
 *
 * @param index counts the fouls of a match from 1
 * @param type what was done
 * @param player who did it
 */
public record Foul(int index, FoulType type, PlayerNumber player) {}
