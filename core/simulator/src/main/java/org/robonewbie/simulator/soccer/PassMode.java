package org.robonewbie.simulator.soccer;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Pass mode of one team, and the period after it during which the team may not score (since rcssserver3d 0.7.2). */
final class PassMode implements Memory {

    private static final double AWAY_DISTANCE = 1.0;

    private final Match match;
    private final TeamSide side;
    private final Set<Player> touchers = new LinkedHashSet<>();
    private Vector3 start = Vector3.ZERO;
    private long lastTick = FoulHistory.NEVER;
    private long lockedUntil = FoulHistory.NEVER;
    private boolean ballWasAway;

    PassMode(Match match, TeamSide side) {
        this.match = match;
        this.side = side;
    }

    /** Starts pass mode for a player's team if all conditions for it are met. */
    void request(Player player) {
        if (isPossible() && Referee.flatDistance(player, ball()) <= get(SoccerParameter.PASS_MODE_MAX_BALL_DISTANCE)) {
            match.setPlayMode(PlayModeRules.of(side, PlayMode.PASS_LEFT, PlayMode.PASS_RIGHT));
        }
    }

    void begin() {
        lastTick = match.currentTick();
        start = ball();
    }

    /** Ends pass mode and starts the period during which the team may not score. */
    void end() {
        lastTick = match.currentTick();
        lockedUntil = lastTick + PortableMath.round(get(SoccerParameter.PASS_MODE_SCORE_WAIT_TIME) / Cycle.SECONDS);
        touchers.clear();
        ballWasAway = false;
    }

    /** Allows the team to score. */
    void unlock() {
        lockedUntil = FoulHistory.NEVER;
    }

    /** Allows the team to score once the ball has been touched by two of its players and has left its start position. */
    void update() {
        if (!isLocked()) {
            return;
        }
        Optional<BallTracker.Touch> touch = match.ball().lastTouch();
        touch.filter(last -> last.tick() > lastTick && last.player().side() == side)
                .ifPresent(last -> touchers.add(last.player()));
        ballWasAway |= PortableMath.hypot(ball().x() - start.x(), ball().y() - start.y()) >= AWAY_DISTANCE;
        if (touchers.size() >= 2 && ballWasAway) {
            unlock();
        }
    }

    boolean isLocked() {
        return match.currentTick() < lockedUntil;
    }

    /** Returns the remaining time, in seconds, during which the team may not score. */
    double lockedSeconds() {
        return isLocked() ? (lockedUntil - match.currentTick()) * Cycle.SECONDS : 0;
    }

    private boolean isPossible() {
        double wait = get(SoccerParameter.PASS_MODE_RETRY_WAIT_TIME);
        double opponentDistance = get(SoccerParameter.PASS_MODE_MIN_OPPONENT_BALL_DISTANCE);
        return match.state().playMode() == PlayMode.PLAY_ON
                && (match.currentTick() - lastTick) * Cycle.SECONDS >= wait
                && match.ballVelocity().length() <= get(SoccerParameter.PASS_MODE_MAX_BALL_SPEED)
                && match.players(side).stream()
                        .noneMatch(player -> player.fouls().ballTick() == match.currentTick())
                && match.players(side.opponent()).stream()
                        .allMatch(player -> Referee.flatDistance(player, ball()) >= opponentDistance);
    }

    private double get(SoccerParameter parameter) {
        return match.parameters().get(parameter);
    }

    private Vector3 ball() {
        return match.ball().position();
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        roster.saveAll(touchers, out);
        out.putVector(start);
        out.putLong(lastTick);
        out.putLong(lockedUntil);
        out.putBoolean(ballWasAway);
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        touchers.clear();
        touchers.addAll(roster.restoreAll(in));
        start = in.getVector();
        lastTick = in.getLong();
        lockedUntil = in.getLong();
        ballWasAway = in.getBoolean();
    }
}
