package org.robonewbie.team.skill;

import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.team.world.Spot;
import org.robonewbie.team.world.WorldModel;

/**
 * Kicks the ball far. The kick is a motion of keyframes that begins in the stance, with the ball at one exact place before a foot. So
 * the robot walks there, stops, looks whether the ball lies where it has to, and only then kicks; else it goes on walking.
 */
public final class Kick {

    /** How far the ball usually rolls, metres. */
    public static final double METRES = 6;

    private static final double QUICKEST_SECONDS = 1.2;
    private static final double LONGEST_SECONDS = 4;
    private static final double SECONDS_PER_METRE = 8;
    private static final double DEGREES_PER_SECOND = 60;
    private static final double HURRY_METRES = 0.8;

    private static final Spot BEFORE_LEFT_FOOT = new Spot(0.205, 0.036);
    private static final double AHEAD_TOLERANCE = 0.02;
    private static final double LEFT_TOLERANCE = 0.017;
    private static final double TURN_TOLERANCE = 7;
    private static final double FAR_METRES = 0.9;
    private static final double BEHIND_METRES = 0.12;
    private static final double AROUND_METRES = 0.4;
    private static final double REACTION_SECONDS = 0.7;
    private static final double MOST_SPEED = 0.4;

    private final Limbs body;
    private final Footwork feet;
    private boolean waiting;

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
        double turn = PortableMath.IEEEremainder(directionDegrees - world.pose().headingDegrees(), 360);
        double miss = world.ballFromHere().minus(before(world.ballFromHere())).length();
        return Math.min(LONGEST_SECONDS, QUICKEST_SECONDS + SECONDS_PER_METRE * miss)
                + Math.abs(turn) / DEGREES_PER_SECOND;
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
        boolean left = ball.y() > 0;
        Spot foot = before(ball);
        double patience = world.opponentDistance(world.ball()) < HURRY_METRES ? 2 : 1;
        boolean ready = isThere(ball, foot, turn, patience);
        if (waiting) {
            waitForTheStance(left, ready, isThere(ball, foot, turn, 1.5 * patience));
        } else if (ready) {
            body.walk().stop();
            waiting = true;
        } else {
            approach(ball, foot, turn);
        }
    }

    private void waitForTheStance(boolean left, boolean ready, boolean almost) {
        if (body.walk().isWalking()) {
            body.walk().stop();
            waiting = almost;
        } else {
            waiting = false;
            if (ready) {
                body.motions().start(left ? "kick-left" : "kick-right");
            }
        }
    }

    private static boolean isThere(Spot ball, Spot foot, double turn, double factor) {
        return Math.abs(ball.x() - foot.x()) < factor * AHEAD_TOLERANCE
                && Math.abs(ball.y() - foot.y()) < factor * LEFT_TOLERANCE
                && Math.abs(turn) < factor * TURN_TOLERANCE;
    }

    /** Walks to the place from which the ball lies before the foot; from the wrong side of the ball around it. */
    private void approach(Spot ball, Spot foot, double turn) {
        Spot direction = Spot.polar(turn, 1);
        Spot aside = Spot.polar(turn + 90, 1);
        Spot place = ball.minus(direction.times(foot.x())).minus(aside.times(foot.y()));
        double ahead = ball.dot(direction);
        double miss = place.dot(aside);
        if (place.length() > FAR_METRES) {
            feet.step(place.minus(direction.times(BEHIND_METRES)), turn, false);
        } else if (ahead < 0.1) {
            double side = ball.dot(aside) <= 0 ? 1 : -1;
            feet.step(ball.minus(direction.times(foot.x())).plus(aside.times(side * AROUND_METRES)), turn, true);
        } else if (Math.abs(miss) > 0.06 || Math.abs(turn) > 2 * TURN_TOLERANCE) {
            feet.step(place.minus(direction.times(BEHIND_METRES)), turn, true);
        } else {
            body.walk().towards(gentle(place.x()), gentle(place.y()), turn);
        }
    }

    private static double gentle(double metres) {
        return Math.max(-MOST_SPEED, Math.min(MOST_SPEED, metres / REACTION_SECONDS));
    }
}
