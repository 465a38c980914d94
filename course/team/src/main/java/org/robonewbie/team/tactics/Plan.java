package org.robonewbie.team.tactics;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.talk.TeamRole;

/**
 * What a player means to do.
 *
 * @param role its role
 * @param action what it does
 * @param target where it goes, or where the ball has to go, in the coordinates of the team
 * @param headingDegrees which way it faces there, or the direction of the kick
 * @param receiver whom it passes to; 0 is nobody
 */
public record Plan(TeamRole role, Action action, Translation2d target, double headingDegrees, int receiver) {

    /** What a player does. */
    public enum Action {
        /** Goes to a place. */
        GO,
        /** Looks for the ball. */
        SEARCH,
        /** Brings the ball forward with its feet. */
        DRIBBLE,
        /** Kicks the ball. */
        KICK,
        /** Kicks the ball as far as it can. */
        FAR_KICK,
        /** Stands behind the ball until the receiver of the kick is ready. */
        WAIT,
        /** Keeps the goal. */
        KEEP,
        /** Does nothing. */
        STAND
    }

    /**
     * Means to do the same in another way.
     *
     * @param other what to do
     * @return the changed plan
     */
    public Plan with(Action other) {
        return new Plan(role, other, target, headingDegrees, receiver);
    }

    /** {@return whether the player kicks, or gets ready for that} */
    public boolean kicksNow() {
        return action == Action.KICK || action == Action.FAR_KICK;
    }

    /** {@return whether the player kicks, or waits to kick} */
    public boolean isKick() {
        return kicksNow() || action == Action.WAIT;
    }

    /** A player that knows nothing yet. */
    public static final Plan NONE = new Plan(TeamRole.SUPPORTER, Action.STAND, Translation2d.ORIGIN, 0, 0);
}
