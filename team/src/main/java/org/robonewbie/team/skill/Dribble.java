package org.robonewbie.team.skill;

import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.team.world.Spot;
import org.robonewbie.team.world.WorldModel;

/**
 * Brings the ball forward. The robot gets behind the ball, seen from where the ball has to go, and walks on: the feet push the ball
 * along. As long as the ball does not leave the way, the robot never stops.
 *
 * <p>Ahead of the robot is a cone that begins between the feet. While the ball is in it, the robot walks on and only corrects its way;
 * else it walks around the ball. With an opponent near and the ball ahead it does neither: it runs through the ball.
 *
 * <p>There are two manners. With nobody near, the ball may roll a metre ahead: the robot walks as fast as it can. But a foot that swings
 * is twice as fast as the robot, and a ball that it meets with more than 0.8 m/s bounces off. So whoever wants to keep the ball near brakes
 * before the touch: the robot walks just as fast as it can still brake to a speed at which the ball stays near. A ball that rolls away may be
 * met with more speed.
 */
public final class Dribble {

    private static final double CONTESTED_METRES = 1;
    private static final double CHARGE_DEGREES = 45;
    private static final double CHARGE_METRES = 0.5;
    private static final double BEHIND_METRES = 0.25;
    private static final double AROUND_METRES = 0.35;
    private static final double MOST_TURN = 25;
    private static final double TOUCH_METRES = 0.2;
    private static final double TOUCH_SPEED = 0.3;
    private static final double ROLLING_SHARE = 0.3;
    private static final double ROLLING_SECONDS = 0.05;
    private static final double BRAKING = 0.4;
    private static final double CALM_DEGREES = 3;
    private static final double AHEAD_SECONDS = 0.25;

    /**
     * A manner of dribbling.
     *
     * @param metres half the width of the cone at the feet
     * @param slope how much wider it is for each metre ahead
     * @param aside how far aside of the middle the ball should lie, so that one foot meets it squarely
     * @param calm metres beside that which do not matter
     * @param brakes whether the robot brakes before the touch
     */
    private record Manner(double metres, double slope, double aside, double calm, boolean brakes) {

        static final Manner FAST = new Manner(0.07, 0.22, 0, 0.02, false);
        static final Manner CLOSE = new Manner(0.15, 0.4, 0.03, 0.015, true);

        /** Whether the ball is in the cone. */
        boolean holds(double ahead, double left) {
            return Math.abs(left) <= metres + slope * Math.max(0, ahead - BEHIND_METRES);
        }

        /** The speed from which the robot can still brake before it touches the ball; any speed if it does not want to. */
        double speed(double ahead, double rolling) {
            double touch = TOUCH_SPEED + ROLLING_SHARE * rolling;
            double gap = Math.max(0, ahead - TOUCH_METRES);
            return brakes ? Math.sqrt(touch * touch + 2 * BRAKING * gap) : Double.POSITIVE_INFINITY;
        }

        /** How far the robot has to move to the side. */
        double miss(double left) {
            return beyond(left - Math.signum(left) * aside, calm);
        }
    }

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
     * Brings the ball one step nearer to a place, as fast as the robot can; the ball may roll a metre ahead.
     *
     * @param world where the ball is
     * @param target where the ball has to go, in the coordinates of the team
     */
    public void bring(WorldModel world, Spot target) {
        bring(world, target, Manner.FAST);
    }

    /**
     * Brings the ball one step nearer to a place and keeps it near: mostly within half a metre.
     *
     * @param world where the ball is
     * @param target where the ball has to go, in the coordinates of the team
     */
    public void bringClosely(WorldModel world, Spot target) {
        bring(world, target, Manner.CLOSE);
    }

    private void bring(WorldModel world, Spot target, Manner manner) {
        Spot ball = manner.brakes()
                ? world.ballAtFeetIn(AHEAD_SECONDS)
                : world.ballIn(AHEAD_SECONDS).seenFrom(world.pose());
        Spot now = manner.brakes() ? world.ballAtFeetIn(0).onMap(world.pose()) : world.ball();
        Spot way = target.minus(now);
        double turn = PortableMath.IEEEremainder(way.degrees() - world.pose().headingDegrees(), 360);
        if (isContested(world) && isAhead(ball) && Math.abs(turn) < CHARGE_DEGREES) {
            charge(world, ball, turn);
        } else {
            push(world, ball, turn, manner);
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

    private void push(WorldModel world, Spot ball, double turn, Manner manner) {
        Spot direction = Spot.polar(turn, 1);
        Spot aside = Spot.polar(turn + 90, 1);
        double ahead = ball.dot(direction);
        double left = -ball.dot(aside);
        if (ahead < 0.1) {
            double side = left >= 0 ? 1 : -1;
            feet.step(world, ball.minus(direction.times(BEHIND_METRES)).plus(aside.times(side * AROUND_METRES)), turn);
        } else if (!manner.holds(ahead, left) || Math.abs(turn) > MOST_TURN) {
            feet.step(world, ball.minus(direction.times(BEHIND_METRES)), turn);
        } else {
            Spot rolled = world.ballAtFeetIn(ROLLING_SECONDS).minus(world.ballAtFeetIn(0));
            double rolling = Math.max(0, rolled.dot(direction)) / ROLLING_SECONDS;
            double speed = Math.min(Footwork.speed(world), manner.speed(ahead, rolling));
            double seconds = Math.max(0.5, (ahead - BEHIND_METRES) / speed);
            walk.towards(speed, -manner.miss(left) / seconds, 1.5 * beyond(turn, CALM_DEGREES));
        }
    }

    /** What is left of a deviation after a part that does not matter: each correction makes the robot slower. */
    private static double beyond(double deviation, double calm) {
        return Math.signum(deviation) * Math.max(0, Math.abs(deviation) - calm);
    }
}
