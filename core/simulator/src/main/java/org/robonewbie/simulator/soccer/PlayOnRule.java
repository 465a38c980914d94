package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/** Running play: double touches after a set piece, goals, and the ball leaving the pitch. */
final class PlayOnRule implements PlayModeRule {

    private static final long DOUBLE_TOUCH_TICKS = 5;

    private final Match match;

    PlayOnRule(Match match) {
        this.match = match;
    }

    @Override
    public void apply() {
        match.passMode(TeamSide.LEFT).update();
        match.passMode(TeamSide.RIGHT).update();
        updateSetPiece();
        if (isDoubleTouch()) {
            TeamSide side = match.setPiece().orElseThrow().side().opponent();
            match.setPlayMode(PlayModeRules.of(side, PlayMode.FREE_KICK_LEFT, PlayMode.FREE_KICK_RIGHT));
            return;
        }
        Optional<TeamSide> goal = match.ball().goal();
        if (hasKeeperLeftDuringShootout()) {
            match.scoreGoal(TeamSide.LEFT);
        } else if (goal.isPresent()) {
            judgeGoal(goal.get());
        } else if (!match.ball().isOnField()) {
            judgeOut();
        }
    }

    /**
     * Ends a set piece when another player touches the ball. After a kick-off, a teammate's touch counts only when the
     * ball is outside the centre circle.
     */
    private void updateSetPiece() {
        Optional<SetPiece> piece = match.setPiece();
        Optional<BallTracker.Touch> touch = match.ball().lastTouch();
        if (piece.isEmpty()
                || touch.isEmpty()
                || touch.get().tick() <= piece.get().tick()) {
            return;
        }
        Player player = touch.get().player();
        boolean other = !piece.get().taker().equals(Optional.of(player));
        boolean released = !piece.get().kickOff()
                || player.side() != piece.get().side()
                || isOutsideCentreCircle(match.ball().position());
        if (other && released) {
            match.setSetPiece(Optional.empty());
        } else if (other) {
            match.setSetPiece(piece.map(SetPiece::withoutTaker));
        }
    }

    private boolean isOutsideCentreCircle(Vector3 ball) {
        return PortableMath.hypot(ball.x(), ball.y()) > match.parameters().get(SoccerParameter.FREE_KICK_DISTANCE);
    }

    private boolean isDoubleTouch() {
        Optional<BallTracker.Touch> touch = match.ball().lastTouch();
        return match.hasKickRules()
                && touch.isPresent()
                && match.setPiece()
                        .filter(piece ->
                                piece.taker().equals(Optional.of(touch.get().player())))
                        .filter(piece -> touch.get().tick() >= piece.tick() + DOUBLE_TOUCH_TICKS)
                        .isPresent();
    }

    /**
     * Returns whether a player of the right team has left its penalty area, which is not allowed in a penalty
     * shoot-out.
     */
    private boolean hasKeeperLeftDuringShootout() {
        Area area = match.penaltyArea(TeamSide.RIGHT);
        return match.isShootout()
                && match.players(TeamSide.RIGHT).stream()
                        .map(Player::position)
                        .anyMatch(position ->
                                position.x() < area.minX() || position.y() < area.minY() || position.y() > area.maxY());
    }

    private void judgeGoal(TeamSide goal) {
        TeamSide scorer = goal.opponent();
        Optional<SetPiece> piece = match.setPiece().filter(candidate -> match.hasKickRules());
        boolean ownGoal = piece.isPresent() && piece.get().side() == goal;
        if (ownGoal) {
            corner(scorer);
        } else if (match.passMode(scorer).isLocked()
                || (piece.isPresent() && piece.get().indirect())) {
            goalKick(goal);
        } else {
            match.scoreGoal(scorer);
        }
    }

    private void judgeOut() {
        Optional<TeamSide> toucher =
                match.ball().lastTouch().map(touch -> touch.player().side());
        if (toucher.isEmpty()) {
            return;
        }
        Vector3 ball = match.ball().position();
        if (Math.abs(ball.x()) < match.field().length() / 2 + match.ball().radius()) {
            match.setPlayMode(
                    PlayModeRules.of(toucher.get().opponent(), PlayMode.KICK_IN_LEFT, PlayMode.KICK_IN_RIGHT));
            return;
        }
        TeamSide defenders = ball.x() < 0 ? TeamSide.LEFT : TeamSide.RIGHT;
        if (toucher.get() == defenders) {
            corner(defenders.opponent());
        } else {
            goalKick(defenders);
        }
    }

    private void corner(TeamSide attackers) {
        match.setPlayMode(PlayModeRules.of(attackers, PlayMode.CORNER_KICK_LEFT, PlayMode.CORNER_KICK_RIGHT));
    }

    private void goalKick(TeamSide defenders) {
        match.setPlayMode(PlayModeRules.of(defenders, PlayMode.GOAL_KICK_LEFT, PlayMode.GOAL_KICK_RIGHT));
    }
}
