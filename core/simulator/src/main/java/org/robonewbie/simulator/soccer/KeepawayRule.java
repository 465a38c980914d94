package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;

/** Keep-away: the match ends when the ball leaves a shrinking rectangle or the right team touches it. */
final class KeepawayRule {

    private static final double SECONDS_PER_MINUTE = 60;

    private final Match match;

    KeepawayRule(Match match) {
        this.match = match;
    }

    boolean isGameLost() {
        if (!match.parameters().isOn(SoccerParameter.KEEPAWAY) || match.state().playSeconds() <= 0) {
            return false;
        }
        Optional<TeamSide> toucher =
                match.ball().lastTouch().map(touch -> touch.player().side());
        return toucher.equals(Optional.of(TeamSide.RIGHT))
                || !area().contains(match.ball().position());
    }

    private Area area() {
        double length = shrunk(SoccerParameter.KEEPAWAY_LENGTH, SoccerParameter.KEEPAWAY_LENGTH_REDUCTION_RATE);
        double width = shrunk(SoccerParameter.KEEPAWAY_WIDTH, SoccerParameter.KEEPAWAY_WIDTH_REDUCTION_RATE);
        double x = match.parameters().get(SoccerParameter.KEEPAWAY_CENTER_X);
        double y = match.parameters().get(SoccerParameter.KEEPAWAY_CENTER_Y);
        return new Area(x - length / 2, x + length / 2, y - width / 2, y + width / 2);
    }

    private double shrunk(SoccerParameter size, SoccerParameter ratePerMinute) {
        double minutes = match.state().playSeconds() / SECONDS_PER_MINUTE;
        return Math.max(
                0, match.parameters().get(size) - minutes * match.parameters().get(ratePerMinute));
    }
}
