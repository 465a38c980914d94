package org.robonewbie.simulator.soccer;

import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Kick-in, corner kick and free kick: the ball is held at its spot and opponents are kept away. */
final class FreeKickRule implements PlayModeRule {

    private final Match match;
    private final TeamSide side;
    private final boolean indirect;
    private final Supplier<Vector3> spotSupplier;
    private final KickPreparation preparation;
    private Vector3 spot = Vector3.ZERO;

    FreeKickRule(Match match, TeamSide side, boolean indirect, Supplier<Vector3> spotSupplier) {
        this.match = match;
        this.side = side;
        this.indirect = indirect;
        this.spotSupplier = spotSupplier;
        this.preparation = new KickPreparation(match, side);
    }

    @Override
    public void begin() {
        spot = spotSupplier.get();
        preparation.begin();
    }

    @Override
    public void apply() {
        if (preparation.isPausing()) {
            return;
        }
        double distance = match.parameters().get(SoccerParameter.FREE_KICK_DISTANCE);
        double moveDistance = match.parameters().get(SoccerParameter.FREE_KICK_MOVE_DISTANCE);
        match.repositioning().clearCircle(side.opponent(), spot, distance, moveDistance);
        if (preparation.dropIfLate(spot)) {
            return;
        }
        Optional<Player> taker = preparation.holdBall(spot);
        if (taker.isPresent()) {
            match.setSetPiece(Optional.of(new SetPiece(side, taker, match.currentTick(), indirect, false)));
            match.setPlayMode(PlayMode.PLAY_ON);
        }
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        out.putVector(spot);
        preparation.save(out);
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        spot = in.getVector();
        preparation.restore(in);
    }
}
