package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * Set piece that started the current play, valid until another robot touches the ball.
 *
 * @param side team that took the kick
 * @param taker player that took the kick
 * @param tick tick of the kick
 * @param indirect whether the kick must not go directly into the opponents' goal
 * @param kickOff whether it is a kick-off, which stays indirect until the ball is touched outside the centre circle
 */
record SetPiece(TeamSide side, Optional<Player> taker, long tick, boolean indirect, boolean kickOff) {

    SetPiece withoutTaker() {
        return new SetPiece(side, Optional.empty(), tick, indirect, kickOff);
    }

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
