package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Clock, half, score and play mode. */
public final class MatchState {

    private PlayMode playMode = PlayMode.BEFORE_KICK_OFF;
    private long playTicks;
    private long modeTicks;
    private int half = 1;
    private int scoreLeft;
    private int scoreRight;

    /** {@return the play mode} */
    public PlayMode playMode() {
        return playMode;
    }

    /**
     * {@return the game time in seconds; it is stopped before a kick-off and after the game, and runs on from the first half to
     * the second}
     */
    public double playSeconds() {
        return playTicks * Cycle.SECONDS;
    }

    /** {@return how long the play mode has lasted, in seconds} */
    public double modeSeconds() {
        return modeTicks * Cycle.SECONDS;
    }

    /** {@return the half, 1 or 2} */
    public int half() {
        return half;
    }

    /**
     * Returns the goals of a team.
     *
     * @param side the team on this side
     * @return its goals
     */
    public int score(TeamSide side) {
        return side == TeamSide.LEFT ? scoreLeft : scoreRight;
    }

    void tick(boolean anybodyThere) {
        if (playMode == PlayMode.BEFORE_KICK_OFF) {
            modeTicks += anybodyThere ? 1 : 0;
            return;
        }
        modeTicks++;
        if (playMode != PlayMode.GAME_OVER) {
            playTicks++;
        }
    }

    void setPlayMode(PlayMode newMode) {
        playMode = newMode;
        modeTicks = 0;
    }

    void setPlaySeconds(double seconds) {
        playTicks = PortableMath.round(seconds / Cycle.SECONDS);
    }

    void setHalf(int newHalf) {
        half = newHalf;
    }

    void setScore(int left, int right) {
        scoreLeft = left;
        scoreRight = right;
    }

    void swapScore() {
        setScore(scoreRight, scoreLeft);
    }

    void addGoal(TeamSide side) {
        setScore(scoreLeft + (side == TeamSide.LEFT ? 1 : 0), scoreRight + (side == TeamSide.RIGHT ? 1 : 0));
    }

    void restart() {
        setPlayMode(PlayMode.BEFORE_KICK_OFF);
        playTicks = 0;
        half = 1;
        setScore(0, 0);
    }

    void save(StateWriter out) {
        out.putEnum(playMode);
        out.putLong(playTicks);
        out.putLong(modeTicks);
        out.putInt(half);
        out.putInt(scoreLeft);
        out.putInt(scoreRight);
    }

    void restore(StateReader in) {
        playMode = in.getEnum(PlayMode.values());
        playTicks = in.getLong();
        modeTicks = in.getLong();
        half = in.getInt();
        setScore(in.getInt(), in.getInt());
    }
}
