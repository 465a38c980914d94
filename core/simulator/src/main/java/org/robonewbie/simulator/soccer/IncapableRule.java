package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.monitor.FoulType;

/** Incapable foul: a robot that has been down for too long is removed from the pitch. */
final class IncapableRule implements FoulRule {

    private static final double GROUND_HEIGHT = 0.15;
    private static final double STANDING_HEIGHT = 0.25;
    private static final double MARGIN = 0.1;
    private static final int TICKS_UNTIL_STANDING = 25;

    private final Match match;

    IncapableRule(Match match) {
        this.match = match;
    }

    @Override
    public void judge() {
        match.players().forEach(this::judge);
    }

    private void judge(Player player) {
        FoulHistory fouls = player.fouls();
        if (fouls.isPunished()) {
            return;
        }
        if (Math.abs(player.position().y()) < match.field().width() / 2 + MARGIN) {
            double height = player.position().z();
            fouls.countLying(height < GROUND_HEIGHT, height >= STANDING_HEIGHT, TICKS_UNTIL_STANDING);
        }
        boolean keeper = player.isGoalkeeper();
        double groundLimit = match.parameters()
                .get(keeper ? SoccerParameter.GOALIE_GROUND_MAX_TIME : SoccerParameter.GROUND_MAX_TIME);
        double standingLimit = match.parameters()
                .get(keeper ? SoccerParameter.GOALIE_NOT_STANDING_MAX_TIME : SoccerParameter.NOT_STANDING_MAX_TIME);
        if (fouls.groundTicks() * Cycle.SECONDS > groundLimit
                || fouls.notStandingTicks() * Cycle.SECONDS > standingLimit) {
            match.referee().punish(player, FoulType.INCAPABLE);
        }
    }
}
