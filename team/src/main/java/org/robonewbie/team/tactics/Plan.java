package org.robonewbie.team.tactics;

import org.robonewbie.team.world.Spot;

/**
 * What a player means to do.
 *
 * @param role its role
 * @param action what it does
 * @param target where it goes, or where the ball has to go, in the coordinates of the team
 * @param headingDegrees which way it faces there, or the direction of the kick
 * @param receiver whom it passes to; 0 is nobody
 */
public record Plan(TeamRole role, Action action, Spot target, double headingDegrees, int receiver) {

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
        /** Keeps the goal. */
        KEEP,
        /** Does nothing. */
        STAND
    }

    /** A player that knows nothing yet. */
    public static final Plan NONE = new Plan(TeamRole.SUPPORTER, Action.STAND, Spot.ORIGIN, 0, 0);
}
