package org.robonewbie.team.skill;

import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.team.world.Spot;
import org.robonewbie.team.world.WorldModel;

/**
 * Brings the ball forward. The robot gets behind the ball, seen from where the ball has to go, and walks on: the feet push the ball
 * along. As long as the ball does not leave the way, the robot never stops.
 *
 * <p>Ahead of the robot is a cone that begins between the feet. While the ball is in it, the robot walks with full speed and only
 * corrects its way; else it walks around the ball. With an opponent near and the ball ahead it does neither: it runs through the ball.
 */
public final class Dribble {

    private static final double CONTESTED_METRES = 1;
    private static final double CHARGE_DEGREES = 45;
    private static final double CHARGE_METRES = 0.5;
    private static final double BEHIND_METRES = 0.25;
    private static final double AROUND_METRES = 0.35;
    private static final double CONE_METRES = 0.07;
    private static final double CONE_SLOPE = 0.22;
    private static final double MOST_TURN = 25;
    private static final double CALM_METRES = 0.02;
    private static final double CALM_DEGREES = 3;
    private static final double AHEAD_SECONDS = 0.25;

    private final Walk walk;
    private final Footwork feet;

    /**
     * Prepares the skill.
     *
     * @param walk the walk
     * @param feet walks to places
     */
    public Dribble(Walk walk, Footwork feet) {
        this.walk = walk;
        this.feet = feet;
    }

    /**
     * Brings the ball one step nearer to a place.
     *
     * @param world where the ball is
     * @param target where the ball has to go, in the coordinates of the team
     */
    public void bring(WorldModel world, Spot target) {
        Spot ball = world.ballIn(AHEAD_SECONDS).seenFrom(world.pose());
        Spot way = target.minus(world.ball());
        double turn = PortableMath.IEEEremainder(way.degrees() - world.pose().headingDegrees(), 360);
        if (isContested(world) && isAhead(ball) && Math.abs(turn) < CHARGE_DEGREES) {
            charge(world, ball, turn);
        } else {
            push(world, ball, turn);
        }
    }

    private static boolean isAhead(Spot ball) {
        return ball.length() < CHARGE_METRES && Math.abs(ball.degrees()) < CHARGE_DEGREES;
    }

    private static boolean isContested(WorldModel world) {
        return world.opponentDistance(world.ball()) < CONTESTED_METRES;
    }

    /** Runs through the ball without getting behind it first, since an opponent would take it meanwhile. */
    private void charge(WorldModel world, Spot ball, double turn) {
        walk.towards(Footwork.speed(world), 0, (ball.degrees() + turn) / 2);
    }

    private void push(WorldModel world, Spot ball, double turn) {
        Spot direction = Spot.polar(turn, 1);
        Spot aside = Spot.polar(turn + 90, 1);
        double ahead = ball.dot(direction);
        double left = -ball.dot(aside);
        if (ahead < 0.1) {
            double side = left >= 0 ? 1 : -1;
            feet.step(world, ball.minus(direction.times(BEHIND_METRES)).plus(aside.times(side * AROUND_METRES)), turn);
        } else if (Math.abs(left) > CONE_METRES + CONE_SLOPE * Math.max(0, ahead - BEHIND_METRES)
                || Math.abs(turn) > MOST_TURN) {
            feet.step(world, ball.minus(direction.times(BEHIND_METRES)), turn);
        } else {
            double speed = Footwork.speed(world);
            double seconds = Math.max(0.5, (ahead - BEHIND_METRES) / speed);
            walk.towards(speed, -beyond(left, CALM_METRES) / seconds, 1.5 * beyond(turn, CALM_DEGREES));
        }
    }

    /** What is left of a deviation after a part that does not matter: each correction makes the robot slower. */
    private static double beyond(double deviation, double calm) {
        return Math.signum(deviation) * Math.max(0, Math.abs(deviation) - calm);
    }
}
