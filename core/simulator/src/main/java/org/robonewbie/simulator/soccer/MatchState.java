package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Clock, half, score and play mode of a match. */
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
     * {@return the game time in seconds; the clock is stopped before a kick-off and after the game, and is not reset at
     * half-time}
     */
    public double playSeconds() {
        return playTicks * Cycle.SECONDS;
    }

    /** {@return the time in seconds since the last change of the play mode} */
    public double modeSeconds() {
        return modeTicks * Cycle.SECONDS;
    }

    /** {@return the half, 1 or 2} */
    public int half() {
        return half;
    }

    /**
     * Returns the number of goals that a team has scored.
     *
     * @param side side of the team
     * @return number of goals
     */
    public int score(TeamSide side) {
        return side == TeamSide.LEFT ? scoreLeft : scoreRight;
    }

    void tick(boolean hasRobots) {
        if (playMode == PlayMode.BEFORE_KICK_OFF) {
            modeTicks += hasRobots ? 1 : 0;
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

    /**
     * Sets the game time. Does not change the time since the last change of the play mode.
     *
     * @param seconds game time in seconds, at least 0
     */
    public void setPlaySeconds(double seconds) {
        playTicks = PortableMath.round(seconds / Cycle.SECONDS);
    }

    /**
     * Sets the half.
     *
     * @param newHalf 1 or 2
     */
    public void setHalf(int newHalf) {
        half = newHalf;
    }

    /**
     * Sets the score.
     *
     * @param left goals of the left team
     * @param right goals of the right team
     */
    public void setScore(int left, int right) {
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
