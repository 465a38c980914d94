package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Goal kick: opponents leave the penalty area, and play resumes when the ball has left it. */
final class GoalKickRule implements PlayModeRule {

    private final Match match;
    private final TeamSide side;
    private final KickPreparation preparation;
    private Optional<Player> taker = Optional.empty();

    GoalKickRule(Match match, TeamSide side) {
        this.match = match;
        this.side = side;
        this.preparation = new KickPreparation(match, side);
    }

    @Override
    public void begin() {
        taker = Optional.empty();
        preparation.begin();
    }

    @Override
    public void apply() {
        if (preparation.isPausing()) {
            return;
        }
        Area area = match.penaltyArea(side);
        double moveDistance = match.parameters().get(SoccerParameter.FREE_KICK_MOVE_DISTANCE);
        match.repositioning().clearArea(side.opponent(), area, moveDistance);
        Vector3 spot = Spots.goalKick(match, side);
        if (preparation.dropIfLate(spot)) {
            return;
        }
        if (taker.isEmpty()) {
            taker = preparation.holdBall(spot);
        }
        Vector3 ball = match.ball().position();
        if (taker.isPresent() && !area.contains(ball)) {
            match.setSetPiece(Optional.of(new SetPiece(side, taker, match.currentTick(), false, false)));
            match.setPlayMode(PlayMode.PLAY_ON);
        }
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        out.putOptional(taker, player -> roster.save(player, out));
        preparation.save(out);
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        taker = in.getOptional(() -> roster.restore(in));
        preparation.restore(in);
    }
}
