package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Common behaviour of all set pieces: a pause, after which the ball is held at its spot until a robot touches it. */
final class KickPreparation {

    private static final double SETTLING_SECONDS = 0.03;

    private final Match match;
    private final TeamSide side;
    private final double pauseSeconds;
    private long firstTouchTick;
    private boolean repelled;

    KickPreparation(Match match, TeamSide side) {
        this.match = match;
        this.side = side;
        pauseSeconds = match.parameters().get(SoccerParameter.RULE_KICK_IN_PAUSE_TIME);
    }

    void begin() {
        repelled = false;
        firstTouchTick = match.currentTick() + PortableMath.round((pauseSeconds + SETTLING_SECONDS) * 50);
    }

    boolean isPausing() {
        return match.state().modeSeconds() < pauseSeconds;
    }

    /**
     * Returns whether the time limit for a kick has expired and the ball must be dropped. A limit of 0 means no limit.
     */
    static boolean isLate(Match match) {
        double limit = match.parameters().get(SoccerParameter.RULE_DROP_BALL_TIME);
        return limit > 0 && match.state().modeSeconds() > limit;
    }

    /** Drops the ball if the time limit for the kick has expired; returns whether the ball was dropped. */
    boolean dropIfLate(Vector3 spot) {
        boolean late = isLate(match);
        if (late) {
            match.dropBall(spot);
        }
        return late;
    }

    /**
     * Holds the ball at its spot and returns the player that has kicked it. As in SimSpark, the ball is not moved before
     * the first touch of the match; this matters only when a trainer sets the play mode.
     */
    Optional<Player> holdBall(Vector3 spot) {
        Optional<Player> toucher = match.ball().touchedAfter(firstTouchTick);
        if (toucher.isEmpty() && match.ball().lastTouch().isPresent()) {
            repelOnce(spot);
            match.ball().place(spot);
        }
        return toucher;
    }

    private void repelOnce(Vector3 spot) {
        if (!repelled) {
            repelled = true;
            double distance = match.parameters().get(SoccerParameter.KICK_REPEL_DISTANCE);
            match.repositioning().pushAway(side, spot, distance, distance);
        }
    }

    void save(StateWriter out) {
        out.putLong(firstTouchTick);
        out.putBoolean(repelled);
    }

    void restore(StateReader in) {
        firstTouchTick = in.getLong();
        repelled = in.getBoolean();
    }
}
