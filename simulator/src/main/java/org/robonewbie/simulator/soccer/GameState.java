package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;

/** Clock, half, score and play mode. */
public final class GameState {

    private static final double TICK_SECONDS = 0.02;

    private PlayMode playMode = PlayMode.BEFORE_KICK_OFF;
    private long playTicks;
    private long modeTicks;
    private int half = 1;
    private int scoreLeft;
    private int scoreRight;

    /**
     * Tells what the referee has decided.
     *
     * @return the play mode
     */
    public PlayMode playMode() {
        return playMode;
    }

    /**
     * Tells the time of play; it stands still before a kick-off and after the game, and goes on from the first half to
     * the second.
     *
     * @return seconds
     */
    public double playSeconds() {
        return playTicks * TICK_SECONDS;
    }

    /**
     * Tells for how long the play mode has lasted.
     *
     * @return seconds
     */
    public double modeSeconds() {
        return modeTicks * TICK_SECONDS;
    }

    /**
     * Tells which half is played.
     *
     * @return 1 or 2
     */
    public int half() {
        return half;
    }

    /**
     * Counts goals.
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
        playTicks = Math.round(seconds / TICK_SECONDS);
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
}
