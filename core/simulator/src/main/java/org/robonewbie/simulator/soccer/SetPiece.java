package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * The kick with which play went on, remembered until another robot has touched the ball.
 *
 * @param side the team that had the kick
 * @param taker who kicked
 * @param tick when
 * @param indirect whether the kick may not go into the opponents' goal
 * @param kickOff whether it was a kick-off, which stays indirect until the ball is touched outside the centre circle
 */
record SetPiece(TeamSide side, Optional<Player> taker, long tick, boolean indirect, boolean kickOff) {

    void save(StateWriter out, Roster roster) {
        out.putEnum(side);
        out.putOptional(taker, player -> roster.save(player, out));
        out.putLong(tick);
        out.putBoolean(indirect);
        out.putBoolean(kickOff);
    }

    static SetPiece restore(StateReader in, Roster roster) {
        return new SetPiece(
                in.getEnum(TeamSide.values()),
                in.getOptional(() -> roster.restore(in)),
                in.getLong(),
                in.getBoolean(),
                in.getBoolean());
    }
}
