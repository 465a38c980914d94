package org.robonewbie.team.skill;

import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Where the ball lies on the way on which it has to go, seen from the robot.
 *
 * @param ball the ball, seen from the robot
 * @param turn degrees by which the robot has to turn to the left to look along the way
 */
record BallOnWay(Translation2d ball, double turn) {

    private static final double BEHIND_METRES = 0.25;
    private static final double AROUND_METRES = 0.35;
    private static final double MIN_AHEAD = 0.1;
    private static final double MAX_TURN = 25;

    /** The ball where the robot expects it when its next steps take effect, and the way from where it is now to a target on the map. */
    static BallOnWay of(WorldModel world, Translation2d expected, Translation2d now, Translation2d target) {
        double way = target.minus(now).degrees();
        return new BallOnWay(expected, Angles.wrap(way - world.pose().degrees()));
    }

    /** How far ahead of the robot the ball is along the way, in metres. */
    double ahead() {
        return ball.dot(direction());
    }

    /** How far the robot is to the left of the ball across the way, in metres. */
    double aside() {
        return -ball.dot(left());
    }

    /** Whether the robot is behind the ball: it looks along the way, and the ball is in a cone that begins between the feet. */
    boolean isInCone(double metres, double slope) {
        double width = metres + slope * Math.max(0, ahead() - BEHIND_METRES);
        return ahead() >= MIN_AHEAD && Math.abs(aside()) <= width && Math.abs(turn) <= MAX_TURN;
    }

    /** Walks to the place behind the ball; around it if it is behind the robot. */
    void getBehind(Footwork feet, WorldModel world) {
        Translation2d behind = ball.minus(direction().times(BEHIND_METRES));
        double side = aside() >= 0 ? 1 : -1;
        Translation2d place = ahead() < MIN_AHEAD ? behind.plus(left().times(side * AROUND_METRES)) : behind;
        feet.step(world, place, turn);
    }

    private Translation2d direction() {
        return Translation2d.polar(turn, 1);
    }

    private Translation2d left() {
        return Translation2d.polar(turn + 90, 1);
    }

    /** What is left of a deviation after a part that does not matter: each correction makes the robot slower. */
    static double beyond(double deviation, double calm) {
        return Math.signum(deviation) * Math.max(0, Math.abs(deviation) - calm);
    }
}
