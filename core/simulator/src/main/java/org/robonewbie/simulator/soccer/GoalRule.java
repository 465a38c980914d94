package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;

/** After a goal: a pause in which robots may be beamed, then a kick-off for the other team. */
final class GoalRule implements PlayModeRule {

    private final Match match;
    private final TeamSide scorer;
    private final OpponentHalfRule opponentHalf;

    GoalRule(Match match, TeamSide scorer) {
        this.match = match;
        this.scorer = scorer;
        this.opponentHalf = new OpponentHalfRule(match);
    }

    @Override
    public void apply() {
        opponentHalf.clearForKickOff(scorer.opponent());
        if (match.state().modeSeconds() >= match.parameters().get(SoccerParameter.RULE_GOAL_PAUSE_TIME)) {
            match.setSetPiece(Optional.empty());
            match.ball().place(match.centreSpot());
            match.kickOff(scorer.opponent());
        }
    }
}
