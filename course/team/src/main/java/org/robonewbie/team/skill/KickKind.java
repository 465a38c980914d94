package org.robonewbie.team.skill;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;

/** Kinds of kicks, each with the ball position that it requires. */
public enum KickKind {

    /** A quick kick of more than five metres, for use when opponents are near. */
    QUICK("quick-kick-left", "quick-kick-right", 0.0375, 0.028, 0.027, 8),

    /**
     * A high kick of 13 m, in which the robot hops forward. The foot swings across the body, so the right foot kicks a ball on
     * the left.
     */
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
     * Returns whether a robot type can perform the kick: in a far kick, robots with longer legs or toes stub the foot on the
     * ground and fall.
     *
     * @param type the robot type
     * @return whether robots of the type can perform the kick
     */
    public boolean isFor(RobotType type) {
        return this == QUICK || type == RobotType.TYPE_0 || type == RobotType.TYPE_2;
    }

    /**
     * {@return the typical range in metres; for the far kick this is below the mean, because a shot has to reach the goal}
     */
    public double metres() {
        return this == QUICK ? 5.4 : 13;
    }

    /** {@return the time in seconds that a robot in position needs until the foot hits the ball} */
    public double seconds() {
        return this == QUICK ? 1.4 : 1.5;
    }

    /**
     * Returns whether the ball is high after a given distance. Robots seldom stop a high ball, and it may pass over the
     * crossbar at 0.8 m.
     *
     * @param metres distance that the ball has travelled
     * @return whether it is high at that point
     */
    public boolean isHigh(double metres) {
        return this == FAR && metres > 1.2 && metres < 6.5;
    }

    /** Returns the name of the motion for a ball on the left or right. */
    String motion(boolean isOnLeft) {
        return isOnLeft ? onLeft : onRight;
    }

    /**
     * Returns the required position of a ball on the left, in the robot's frame. Robots with longer legs need the ball
     * elsewhere for the same joint angles.
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

    /** Returns the settling time in seconds between the walk and the kick; robots with longer legs sway after stopping. */
    double calmSeconds(RobotType type) {
        return switch (type) {
            case TYPE_1 -> 0.3;
            case TYPE_3 -> 0.6;
            default -> 0;
        };
    }

    /** Returns by how many metres the ball may be closer to the robot than required. */
    double nearer() {
        return nearer;
    }

    /** Returns by how many metres the ball may be farther from the robot than required. */
    double farther() {
        return farther;
    }

    /** Returns the lateral tolerance in metres. */
    double aside() {
        return aside;
    }

    /** Returns the heading tolerance in degrees. */
    double turned() {
        return turned;
    }
}
