package org.robonewbie.team.world;

import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;

/** State of the game from the perspective of one team. */
public enum Situation {
    /** Time before the kick-off and after a goal, during which robots may beam. */
    LINE_UP,
    /** Both teams may play the ball. */
    OPEN_PLAY,
    /** This team is in pass mode: the opponents must stay a metre away from the ball. */
    OUR_PASS,
    /** This team kicks off. */
    OUR_KICK_OFF,
    /** The opponents kick off. */
    THEIR_KICK_OFF,
    /** This team has a kick-in, corner, goal kick or free kick; the opponents keep away. */
    OUR_KICK,
    /** The opponents have a kick-in, corner, goal kick, free kick or pass. */
    THEIR_KICK,
    /** The game is over. */
    OVER;

    /**
     * Converts a play mode to a team's perspective.
     *
     * @param mode the referee's play mode
     * @param side the half that the team defends
     * @return the team's situation
     */
    public static Situation of(PlayMode mode, TeamSide side) {
        return switch (mode) {
            case BEFORE_KICK_OFF, GOAL_LEFT, GOAL_RIGHT -> LINE_UP;
            case GAME_OVER -> OVER;
            case KICK_OFF_LEFT -> side == TeamSide.LEFT ? OUR_KICK_OFF : THEIR_KICK_OFF;
            case KICK_OFF_RIGHT -> side == TeamSide.RIGHT ? OUR_KICK_OFF : THEIR_KICK_OFF;
            case PASS_LEFT -> side == TeamSide.LEFT ? OUR_PASS : THEIR_KICK;
            case PASS_RIGHT -> side == TeamSide.RIGHT ? OUR_PASS : THEIR_KICK;
            default ->
                mode.kicker()
                        .map(kicker -> kicker == side ? OUR_KICK : THEIR_KICK)
                        .orElse(OPEN_PLAY);
        };
    }

    /** {@return whether both teams may play the ball, which includes pass mode} */
    public boolean isOpen() {
        return this == OPEN_PLAY || this == OUR_PASS;
    }

    /** {@return whether only this team may play the ball} */
    public boolean isOurs() {
        return this == OUR_KICK_OFF || this == OUR_KICK;
    }

    /** {@return whether only the opponents may play the ball} */
    public boolean isTheirs() {
        return this == THEIR_KICK_OFF || this == THEIR_KICK;
    }
}
