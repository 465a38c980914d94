package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Pass mode: keeps opponents away from the ball until a robot touches it or the time has elapsed. */
final class PassRule implements PlayModeRule {

    private static final double PUSH = 0.1;

    private final Match match;
    private final TeamSide side;
    private final PlayModeRule playOn;
    private long beginTick;

    PassRule(Match match, TeamSide side, PlayModeRule playOn) {
        this.match = match;
        this.side = side;
        this.playOn = playOn;
    }

    @Override
    public void begin() {
        beginTick = match.currentTick();
        match.passMode(side).begin();
        match.passMode(side.opponent()).unlock();
    }

    @Override
    public void apply() {
        double distance = match.parameters().get(SoccerParameter.PASS_MODE_MIN_OPPONENT_BALL_DISTANCE);
        match.repositioning().pushAway(side.opponent(), match.ball().position(), distance, distance + PUSH);
        boolean touched = match.ball().touchedAfter(beginTick).isPresent();
        if (touched || match.state().modeSeconds() >= match.parameters().get(SoccerParameter.PASS_MODE_DURATION)) {
            match.setPlayMode(PlayMode.PLAY_ON);
            match.passMode(side).end();
        }
        playOn.apply();
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        out.putLong(beginTick);
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        beginTick = in.getLong();
    }
}
