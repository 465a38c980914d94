package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

/** What a trainer may change in a game besides what the referee decides: clock, score, and where players stand. */
public final class TrainerActions {

    private static final double HEIGHT_METRES = 1;

    private final Match match;

    /**
     * Reaches into a game.
     *
     * @param match the game
     */
    public TrainerActions(Match match) {
        this.match = match;
    }

    /**
     * Sets the clock; for how long the play mode has lasted does not change.
     *
     * @param seconds the new time of play, at least 0
     */
    public void setPlaySeconds(double seconds) {
        match.state().setPlaySeconds(seconds);
    }

    /**
     * Sets the score.
     *
     * @param left goals of the left team
     * @param right goals of the right team
     */
    public void setScore(int left, int right) {
        match.state().setScore(left, right);
    }

    /**
     * Sets which half is played.
     *
     * @param half 1 or 2
     */
    public void setHalf(int half) {
        match.state().setHalf(half);
    }

    /**
     * Places a player beside the pitch.
     *
     * @param player the player
     */
    public void putBesidePitch(Player player) {
        player.robot().moveTo(Spots.besidePitch(match, player).plus(new Vector3(0, 0, HEIGHT_METRES)));
    }

    /**
     * Moves a player back towards its own goal line.
     *
     * @param player the player
     */
    public void moveTowardsOwnGoal(Player player) {
        double distance = match.parameters().get(SoccerParameter.FREE_KICK_MOVE_DISTANCE);
        double x = player.side() == TeamSide.LEFT ? -distance : distance;
        player.robot().moveTo(player.position().plus(new Vector3(x, 0, 0)));
    }
}
