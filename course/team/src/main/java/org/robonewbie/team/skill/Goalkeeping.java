package org.robonewbie.team.skill;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.BallFilter;
import org.robonewbie.team.world.WorldModel;

/**
 * Goalkeeping: stands between the ball and the goal, and dives for a ball that would cross the line.
 *
 * <p>A dive takes a second, but a ball that is kicked from a few metres away arrives in half that time. So a keeper without
 * teammates comes out: the closer it is to the ball, the smaller the part of the goal that it leaves open. It clears the
 * ball if it can reach it well before the attacker.
 */
public final class Goalkeeping {

    private static final double REACH_METRES = 0.12;
    private static final double MAX_REACH_METRES = 0.9;
    private static final double DANGER_SECONDS = 1.6;
    private static final double MIN_SPEED = 0.8;
    private static final double OUT_METRES = 0.7;
    private static final double COMES_OUT_METRES = 4;
    private static final double BEFORE_BALL_METRES = 0.4;
    private static final double MAX_OF_WAY = 0.8;
    private static final double LEAD_METRES = 0.4;

    private final Limbs body;

    /**
     * Creates the skill.
     *
     * @param body the robot
     */
    public Goalkeeping(Limbs body) {
        this.body = body;
    }

    /**
     * Returns the position at which the keeper should stand.
     *
     * @param world the world model
     * @return the position in team coordinates
     */
    public static Translation2d place(WorldModel world) {
        Translation2d goal = world.ourGoal();
        if (comesOut(world)) {
            double away = Math.min(BEFORE_BALL_METRES, MAX_OF_WAY * world.ball().distanceTo(goal));
            return world.ball().towards(goal, away);
        }
        Translation2d place =
                goal.towards(world.ball(), Math.min(OUT_METRES, world.ball().distanceTo(goal) / 2));
        return new Translation2d(Math.max(place.x(), goal.x() + 0.25), place.y());
    }

    /**
     * Returns whether the keeper leaves its line.
     *
     * @param world the world model
     * @return whether it has no teammates and the ball is near
     */
    public static boolean comesOut(WorldModel world) {
        return world.mates().isEmpty() && world.ball().distanceTo(world.ourGoal()) < COMES_OUT_METRES;
    }

    /**
     * Returns whether a keeper without teammates should clear the ball.
     *
     * @param world the world model
     * @return whether it will clearly reach the ball first
     */
    public static boolean mayClear(WorldModel world) {
        double own = world.place().distanceTo(world.ball());
        return world.mates().isEmpty() && world.opponentDistance(world.ball()) > own + LEAD_METRES;
    }

    /**
     * Dives if the ball is about to roll into the goal beside the robot.
     *
     * @param world the world model
     * @return whether the robot dives
     */
    public boolean dive(WorldModel world) {
        double crossing = crossing(world);
        if (Double.isNaN(crossing) || Math.abs(crossing) < REACH_METRES || Math.abs(crossing) > MAX_REACH_METRES) {
            return false;
        }
        body.walk().stop();
        return !body.walk().isWalking() && body.motions().start(crossing > 0 ? "dive-left" : "dive-right");
    }

    /**
     * Returns the lateral distance at which a dangerous ball will pass the robot, in metres to the left; NaN if there is no
     * danger.
     */
    private static double crossing(WorldModel world) {
        Translation2d ball = world.ball();
        Translation2d velocity = world.ballVelocity();
        Translation2d end = ball.plus(velocity.times(BallFilter.ROLLING_SECONDS));
        double line = world.ourGoal().x();
        boolean fast = velocity.x() < -MIN_SPEED && world.ownBallAgeSeconds() < 0.2;
        double way = ball.x() - world.place().x();
        if (!fast || end.x() > line || way < 0 || way / -velocity.x() > DANGER_SECONDS) {
            return Double.NaN;
        }
        double slope = velocity.y() / velocity.x();
        double atLine = ball.y() + slope * (line - ball.x());
        double here = ball.y() + slope * (world.place().x() - ball.x());
        boolean towardsGoal = Math.abs(atLine) < world.field().goalWidth() / 2 + 0.15;
        double facing = Math.abs(world.pose().degrees()) < 90 ? 1 : -1;
        return towardsGoal ? facing * (here - world.place().y()) : Double.NaN;
    }
}
