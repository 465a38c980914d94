package org.robonewbie.team.skill;

import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Position of the ball relative to the robot and to the ball's intended path.
 *
 * @param ball position of the ball in the robot's frame
 * @param turn direction of the path relative to the robot's heading, in degrees to the left
 */
record BallOnWay(Translation2d ball, double turn) {

    private static final double BEHIND_METRES = 0.25;
    private static final double MIN_AHEAD = 0.1;
    private static final double MAX_TURN = 25;

    /**
     * Locates the ball relative to its path, which leads from its current position to the target.
     *
     * @param world the robot's pose
     * @param expected the ball's predicted position when the robot's next steps take effect
     * @param now the ball's current position
     * @param target the end of the path
     */
    static BallOnWay of(WorldModel world, Translation2d expected, Translation2d now, Translation2d target) {
        double way = target.minus(now).degrees();
        return new BallOnWay(expected, Angles.wrap(way - world.pose().degrees()));
    }

    /** Returns the distance in metres along the path by which the ball is ahead of the robot. */
    double ahead() {
        return ball.dot(direction());
    }

    /** Returns the distance in metres across the path by which the robot is to the left of the ball. */
    double aside() {
        return -ball.dot(left());
    }

    /**
     * Returns whether the robot is behind the ball: it faces along the path, and the ball is in a cone with its apex between
     * the feet.
     */
    boolean isInCone(double metres, double slope) {
        return isInCone(metres, slope, MAX_TURN);
    }

    /** Returns the same for a robot that may face the path at a given angle in degrees. */
    boolean isInCone(double metres, double slope, double maxTurn) {
        double width = metres + slope * Math.max(0, ahead() - BEHIND_METRES);
        return ahead() >= MIN_AHEAD && Math.abs(aside()) <= width && Math.abs(turn) <= maxTurn;
    }

    /** Makes the robot walk to the position behind the ball, around the ball if necessary. */
    void getBehind(Footwork feet, WorldModel world) {
        Translation2d behind = ball.minus(direction().times(world.abilities().behindBallMetres()));
        double side = aside() >= 0 ? 1 : -1;
        Translation2d place = ahead() < MIN_AHEAD
                ? behind.plus(left().times(side * world.abilities().aroundBallMetres()))
                : behind;
        feet.step(world, place, turn);
    }

    private Translation2d direction() {
        return Translation2d.polar(turn, 1);
    }

    private Translation2d left() {
        return Translation2d.polar(turn + 90, 1);
    }

    /** Applies a dead band to a deviation, because each correction slows down the robot. */
    static double beyond(double deviation, double deadBand) {
        return Math.signum(deviation) * Math.max(0, Math.abs(deviation) - deadBand);
    }
}
