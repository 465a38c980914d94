package org.robonewbie.simulator.soccer;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** What all kicks have in common: a pause, then the ball is held at its spot until a robot touches it. */
final class KickPreparation {

    private static final double SETTLING_SECONDS = 0.03;

    private final Match match;
    private final TeamSide side;
    private final double pauseSeconds;
    private final double dropBallSeconds;
    private long firstTouchTick;
    private boolean repelled;

    KickPreparation(Match match, TeamSide side) {
        this.match = match;
        this.side = side;
        pauseSeconds = match.parameters().get(SoccerParameter.RULE_KICK_IN_PAUSE_TIME);
        dropBallSeconds = match.parameters().get(SoccerParameter.RULE_DROP_BALL_TIME);
    }

    void begin() {
        repelled = false;
        firstTouchTick = match.currentTick() + PortableMath.round((pauseSeconds + SETTLING_SECONDS) * 50);
    }

    boolean isPausing() {
        return match.state().modeSeconds() < pauseSeconds;
    }

    /** Holds the ball and returns who has kicked it; gives it free for all when it takes too long. */
    Optional<Player> holdBall(Vector3 spot) {
        if (!repelled) {
            repelled = true;
            double distance = match.parameters().get(SoccerParameter.KICK_REPEL_DISTANCE);
            match.repositioning().pushAway(side, spot, distance, distance);
        }
        Optional<Player> toucher = match.ball().touchedAfter(firstTouchTick);
        if (toucher.isEmpty()) {
            match.ball().place(spot);
            if (match.state().modeSeconds() > dropBallSeconds) {
                match.dropBall(spot);
            }
        }
        return toucher;
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
