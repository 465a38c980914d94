package org.robonewbie.simulator.soccer;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.FoulType;

/** Crowding foul: only one robot per team may be near a contested ball. Disabled in the league since 2017. */
final class CrowdingRule implements FoulRule {

    private final Match match;

    CrowdingRule(Match match) {
        this.match = match;
    }

    @Override
    public void judge() {
        if (match.parameters().get(SoccerParameter.MIN_OPPONENT_DISTANCE) > 0) {
            match.referee().sides().forEach(this::judge);
        }
    }

    private void judge(TeamSide side) {
        if (match.state().playMode() == PlayModeRules.of(side, PlayMode.KICK_OFF_LEFT, PlayMode.KICK_OFF_RIGHT)) {
            return;
        }
        Vector3 ball = match.ball().position();
        boolean contested = Referee.nearest(match.players(side.opponent()), ball, 0)
                .filter(opponent -> isWithin(opponent, ball, SoccerParameter.MIN_OPPONENT_DISTANCE))
                .isPresent();
        if (contested) {
            List<Player> free = match.players(side).stream()
                    .filter(player -> !player.fouls().isPunished())
                    .toList();
            judge(Referee.nearest(free, ball, 1), SoccerParameter.MIN_SECOND_PLAYER_DISTANCE);
            judge(Referee.nearest(free, ball, 2), SoccerParameter.MIN_THIRD_PLAYER_DISTANCE);
        }
    }

    private void judge(Optional<Player> player, SoccerParameter distance) {
        player.filter(candidate -> !candidate.isGoalkeeper())
                .filter(candidate -> isWithin(candidate, match.ball().position(), distance))
                .ifPresent(candidate -> match.referee().punish(candidate, FoulType.CROWDING));
    }

    private boolean isWithin(Player player, Vector3 ball, SoccerParameter distance) {
        return Referee.flatDistance(player, ball) < match.parameters().get(distance);
    }
}
