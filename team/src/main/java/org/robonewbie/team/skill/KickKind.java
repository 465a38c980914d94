package org.robonewbie.team.skill;

import org.robonewbie.nao.model.RobotType;
import org.robonewbie.team.world.Spot;

/** How a player kicks, and where the ball has to lie for that. */
public enum KickKind {

    /** Rolls more than five metres, and is begun and done soon: with opponents near there is no time for more. */
    QUICK("quick-kick-left", "quick-kick-right", 0.0375, 0.028, 0.027),

    /** Sends the ball 13 m, high at first; the robot hops ahead. The foot swings across, so a ball on the left is for the right foot. */
    FAR("far-kick-right", "far-kick-left", 0.022, 0.034, 0.022);

    private final String onLeft;
    private final String onRight;
    private final double nearer;
    private final double farther;
    private final double aside;

    KickKind(String onLeft, String onRight, double nearer, double farther, double aside) {
        this.onLeft = onLeft;
        this.onRight = onRight;
        this.nearer = nearer;
        this.farther = farther;
        this.aside = aside;
    }

    /** Returns the motion for a ball on one side. */
    String motion(boolean isOnLeft) {
        return isOnLeft ? onLeft : onRight;
    }

    /**
     * Returns where a ball on the left has to lie, seen from the robot. The same angles bring a longer leg to another place; with these
     * numbers the ball lies in the middle of what the kick reaches.
     */
    Spot ballOnLeft(RobotType type) {
        if (this == FAR) {
            return new Spot(0.21, 0.02);
        }
        return switch (type) {
            case TYPE_1 -> new Spot(0.19, 0.05);
            case TYPE_3 -> new Spot(0.22, 0.055);
            default -> new Spot(0.205, 0.05);
        };
    }

    /** How long the robot waits between walk and kick, in seconds: longer legs leave it rocking. */
    double calmSeconds(RobotType type) {
        return switch (type) {
            case TYPE_1 -> 0.3;
            case TYPE_3 -> 0.6;
            default -> 0;
        };
    }

    /** How much nearer the ball may lie, in metres. */
    double nearer() {
        return nearer;
    }

    /** How much further away the ball may lie, in metres. */
    double farther() {
        return farther;
    }

    /** How much the ball may lie to either side, in metres. */
    double aside() {
        return aside;
    }
}
