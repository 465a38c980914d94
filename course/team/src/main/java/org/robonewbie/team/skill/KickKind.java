package org.robonewbie.team.skill;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;

/** How a player kicks, and where the ball has to lie for that. */
public enum KickKind {

    /** Rolls more than five metres, and is begun and done soon: with opponents near there is no time for more. */
    QUICK("quick-kick-left", "quick-kick-right", 0.0375, 0.028, 0.027, 8),

    /** Sends the ball 13 m, high at first; the robot hops ahead. The foot swings across, so a ball on the left is for the right foot. */
    FAR("far-kick-right", "far-kick-left", 0.022, 0.034, 0.022, 5);

    private final String onLeft;
    private final String onRight;
    private final double nearer;
    private final double farther;
    private final double aside;
    private final double turned;

    KickKind(String onLeft, String onRight, double nearer, double farther, double aside, double turned) {
        this.onLeft = onLeft;
        this.onRight = onRight;
        this.nearer = nearer;
        this.farther = farther;
        this.aside = aside;
        this.turned = turned;
    }

    /**
     * Looks whether a robot can kick so: in a far kick longer legs or toes stub the foot, and the robot falls.
     *
     * @param type how the robot is built
     * @return whether it can
     */
    public boolean isFor(RobotType type) {
        return this == QUICK || type == RobotType.TYPE_0 || type == RobotType.TYPE_2;
    }

    /** {@return how far the ball usually gets, metres; a little less than in the middle for the far kick, since a shot has to get into the goal} */
    public double metres() {
        return this == QUICK ? 5.4 : 13;
    }

    /** {@return how long it takes until the ball is on its way, for a robot that stands before the ball, seconds} */
    public double seconds() {
        return this == QUICK ? 1.4 : 1.5;
    }

    /**
     * Looks whether the ball flies so high that robots seldom stop it, and that it may get over the bar of the goal, which is 0.8 m high.
     *
     * @param metres how far the ball has got
     * @return whether it is high there
     */
    public boolean isHigh(double metres) {
        return this == FAR && metres > 1.2 && metres < 6.5;
    }

    /** Returns the motion for a ball on one side. */
    String motion(boolean isOnLeft) {
        return isOnLeft ? onLeft : onRight;
    }

    /**
     * Returns where a ball on the left has to lie, seen from the robot. The same angles bring a longer leg to another place; with these
     * numbers the ball lies in the middle of what the kick reaches.
     */
    Translation2d ballOnLeft(RobotType type) {
        if (this == FAR) {
            return new Translation2d(0.21, 0.02);
        }
        return switch (type) {
            case TYPE_1 -> new Translation2d(0.19, 0.05);
            case TYPE_3 -> new Translation2d(0.22, 0.055);
            default -> new Translation2d(0.205, 0.05);
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

    /** How far the robot may be turned away from the direction of the kick, in degrees. */
    double turned() {
        return turned;
    }
}
