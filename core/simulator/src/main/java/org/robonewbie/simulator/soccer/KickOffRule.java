package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Kick-off: play starts with the first touch of the ball. */
final class KickOffRule implements PlayModeRule {

    private final Match match;
    private final TeamSide side;
    private final OpponentHalfRule opponentHalf;
    private long beginTick;

    KickOffRule(Match match, TeamSide side) {
        this.match = match;
        this.side = side;
        this.opponentHalf = new OpponentHalfRule(match);
    }

    @Override
    public void begin() {
        beginTick = match.currentTick();
    }

    @Override
    public void apply() {
        opponentHalf.clearForKickOff(side);
        Optional<Player> toucher = match.ball().touchedAfter(beginTick);
        if (toucher.isPresent()) {
            match.setSetPiece(Optional.of(new SetPiece(side, toucher, match.currentTick(), true, true)));
            match.setPlayMode(PlayMode.PLAY_ON);
        } else if (KickPreparation.isLate(match)) {
            match.dropBall(match.ball().position());
        }
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        out.putLong(beginTick);
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        beginTick = in.getLong();
    }
}
