package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;

/**
 * The kick with which play went on, remembered until another robot has touched the ball.
 *
 * @param side the team that had the kick
 * @param taker who kicked
 * @param tick when
 * @param indirect whether the kick may not go into the opponents' goal
 * @param kickOff whether it was a kick-off, which stays indirect until the ball is touched outside the centre circle
 */
record SetPiece(TeamSide side, Optional<Player> taker, long tick, boolean indirect, boolean kickOff) {}
