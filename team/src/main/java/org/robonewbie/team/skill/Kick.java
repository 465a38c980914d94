package org.robonewbie.team.skill;

import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.team.world.Spot;
import org.robonewbie.team.world.WorldModel;

/**
 * Kicks the ball far. The kick is a motion of keyframes that begins in the stance, with the ball before a foot. So the robot walks
 * there, stops, looks whether the ball lies within reach, and only then kicks; else it goes on walking. With an opponent near it is
 * content with less.
 */
public final class Kick {

    /** How far the ball usually rolls, metres. */
    public static final double METRES = 6;

    private static final double USUAL_SECONDS = 1.4;
    private static final double HURRY_METRES = 1;
    private static final double HURRY = 1.4;

    private static final Spot BEFORE_LEFT_FOOT = new Spot(0.2, 0.05);
    private static final double AHEAD_TOLERANCE = 0.027;
    private static final double STEP_TOLERANCE = 0.04;
    private static final double STOPPING_METRES = 0.07;
    private static final double SLOW = 0.15;
    private static final double CLOSER_METRES = 0.03;
    private static final double DRIFT = 1.4;
    private static final double LEFT_TOLERANCE = 0.022;
    private static final double TURN_TOLERANCE = 8;
    private static final double ALIGNED = 1.2;
    private static final double FAR_METRES = 0.9;
    private static final double BEHIND_METRES = 0.16;
    private static final double AROUND_METRES = 0.4;
    private static final double REACTION_SECONDS = 0.6;
    private static final double BRAKES = 0.4;
    private static final double SETTLING_SECONDS = 0.1;

    private final Limbs body;
    private final Footwork feet;
    private boolean waiting;
    private double walkedSeconds;

    /**
     * Prepares the skill.
     *
     * @param body walks and kicks
     * @param feet walks to places
     */
    public Kick(Limbs body, Footwork feet) {
        this.body = body;
        this.feet = feet;
    }

    /**
     * Estimates how long it takes until the ball is on its way, for a robot that is at the ball.
     *
     * @param world where the ball is
     * @param directionDegrees where the ball has to go, in the coordinates of the team
     * @return seconds, without the way to the ball
     */
    public static double seconds(WorldModel world, double directionDegrees) {
        return USUAL_SECONDS + Footwork.aroundSeconds(world, directionDegrees);
    }

    /** Where the ball has to lie for a kick with the foot that is nearer to it. */
    private static Spot before(Spot ball) {
        return new Spot(BEFORE_LEFT_FOOT.x(), (ball.y() > 0 ? 1 : -1) * BEFORE_LEFT_FOOT.y());
    }

    /**
     * Comes one step nearer to the kick, or kicks.
     *
     * @param world where the ball is
     * @param directionDegrees where the ball has to go, in the coordinates of the team
     */
    public void kick(WorldModel world, double directionDegrees) {
        Spot ball = world.ballFromHere();
        double turn = PortableMath.IEEEremainder(directionDegrees - world.pose().headingDegrees(), 360);
        double patience = world.opponentDistance(world.ball()) < HURRY_METRES ? HURRY : 1;
        if (waiting) {
            waitForTheStance(world.seconds(), ball, turn, patience);
        } else if (isThere(afterStop(world), turn, patience, isSlow(world) ? AHEAD_TOLERANCE : STEP_TOLERANCE)) {
            body.walk().stop();
            waiting = true;
        } else {
            approach(world, ball, turn);
        }
    }

    /** Kicks as soon as the robot stands, if the ball is within reach then. */
    private void waitForTheStance(double seconds, Spot ball, double turn, double patience) {
        if (body.walk().isWalking()) {
            body.walk().stop();
            walkedSeconds = seconds;
        }
        if (seconds - walkedSeconds < SETTLING_SECONDS) {
            return;
        }
        waiting = false;
        if (isThere(ball, turn, DRIFT * patience, AHEAD_TOLERANCE)) {
            body.motions().start(ball.y() > 0 ? "quick-kick-left" : "quick-kick-right");
        }
    }

    private static boolean isThere(Spot ball, double turn, double factor, double aheadTolerance) {
        return Math.abs(ball.x() - BEFORE_LEFT_FOOT.x()) < aheadTolerance
                && Math.abs(ball.y() - before(ball).y()) < factor * LEFT_TOLERANCE
                && Math.abs(turn) < factor * factor * TURN_TOLERANCE;
    }

    /** Walks to the place from which the ball lies before the foot; from the wrong side of the ball around it. */
    private void approach(WorldModel world, Spot ball, double turn) {
        Spot foot = before(ball);
        Spot direction = Spot.polar(turn, 1);
        Spot aside = Spot.polar(turn + 90, 1);
        Spot place = ball.minus(direction.times(foot.x())).minus(aside.times(foot.y()));
        double ahead = ball.dot(direction);
        double miss = place.dot(aside);
        if (place.length() > FAR_METRES) {
            feet.step(world, place.minus(direction.times(BEHIND_METRES)), turn);
        } else if (ahead < 0.1) {
            double side = ball.dot(aside) <= 0 ? 1 : -1;
            feet.step(world, ball.minus(direction.times(foot.x())).plus(aside.times(side * AROUND_METRES)), turn);
        } else if (Math.abs(miss) > 0.06 || Math.abs(turn) > ALIGNED * TURN_TOLERANCE) {
            feet.step(world, place.minus(direction.times(BEHIND_METRES)), turn);
        } else {
            double left = place.x() - ball.x() + afterStop(world).x() + (isSlow(world) ? CLOSER_METRES : 0);
            body.walk().towards(gentle(left), gentle(place.y()), turn);
        }
    }

    /** Where the ball lies before the robot when it has come to rest: out of a walk it takes another step or two. */
    private static Spot afterStop(WorldModel world) {
        return world.ballFromHere().minus(new Spot(isSlow(world) ? 0 : STOPPING_METRES, 0));
    }

    private static boolean isSlow(WorldModel world) {
        return world.speedAhead() < SLOW;
    }

    /** How fast the robot may walk so that it still comes to rest in time: in each second it gets slower by a little at most. */
    private static double gentle(double metres) {
        double most = Math.sqrt(2 * BRAKES * Math.abs(metres));
        return Math.max(-most, Math.min(most, metres / REACTION_SECONDS));
    }
}
