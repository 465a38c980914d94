package org.robonewbie.team.tactics;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.talk.TeamRole;

/**
 * Plan of a player.
 *
 * @param role its role
 * @param action its action
 * @param target target of the player or of the ball in team coordinates
 * @param headingDegrees final heading of the player, or direction of the kick, in team coordinates
 * @param receiver player number of the receiver of a pass; 0 for none
 */
public record Plan(TeamRole role, Action action, Translation2d target, double headingDegrees, int receiver) {

    /** Action of a player. */
    public enum Action {
        /** Walks to the target. */
        GO,
        /** Searches for the ball. */
        SEARCH,
        /** Dribbles. */
        DRIBBLE,
        /** Kicks the ball. */
        KICK,
        /** Performs a far kick. */
        FAR_KICK,
        /** Waits behind the ball until the receiver is ready. */
        WAIT,
        /** Guards the goal as the goalkeeper. */
        KEEP,
        /** Stands still. */
        STAND
    }

    /**
     * Returns a copy with the given action.
     *
     * @param other the action
     * @return the changed plan
     */
    public Plan with(Action other) {
        return new Plan(role, other, target, headingDegrees, receiver);
    }

    /** {@return whether the player is kicking or preparing a kick} */
    public boolean kicksNow() {
        return action == Action.KICK || action == Action.FAR_KICK;
    }

    /** {@return whether the player is kicking, preparing a kick or waiting for the receiver} */
    public boolean isKick() {
        return kicksNow() || action == Action.WAIT;
    }

    /** A player's plan before its first decision. */
    public static final Plan NONE = new Plan(TeamRole.SUPPORTER, Action.STAND, Translation2d.ORIGIN, 0, 0);
}
