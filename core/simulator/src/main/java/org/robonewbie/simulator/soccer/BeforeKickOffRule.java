package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;

/** Before a kick-off: the ball is held on the centre spot and robots are kept in their own halves. */
final class BeforeKickOffRule implements PlayModeRule {

    private final Match match;
    private final OpponentHalfRule opponentHalf;

    BeforeKickOffRule(Match match) {
        this.match = match;
        this.opponentHalf = new OpponentHalfRule(match);
    }

    @Override
    public void apply() {
        if (!match.hasRobots()) {
            return;
        }
        match.ball().place(match.centreSpot());
        match.ball().forgetTouches();
        match.setSetPiece(Optional.empty());
        opponentHalf.keepInOwnHalf(TeamSide.LEFT);
        opponentHalf.keepInOwnHalf(TeamSide.RIGHT);
        if (match.parameters().isOn(SoccerParameter.AUTOMATIC_KICK_OFF)
                && match.state().modeSeconds() > match.parameters().get(SoccerParameter.WAIT_BEFORE_KICK_OFF)) {
            match.kickOff();
        }
    }
}
