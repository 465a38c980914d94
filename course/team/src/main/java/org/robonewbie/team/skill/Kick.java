package org.robonewbie.team.skill;

import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * A kick: a keyframe motion that begins in a standing posture with the ball in front of a foot. So the robot walks to
 * the ball and stops; if the ball is then within reach it kicks, otherwise it walks on. With an opponent near, larger
 * deviations are accepted, except in the forward direction: a ball that already touches the foot rolls only two metres,
 * and a ball that is too far from it rolls only one metre. The last step before the stop moves the robot back a little,
 * so it stops only where the ball will still be within reach.
 */
public final class Kick {

    private static final double HURRY_METRES = 1;
    private static final double HURRY = 1.4;

    private static final double STANCE_METRES = 0.016;
    private static final double CLOSER_METRES = 0.03;
    private static final double DRIFT = 1.4;
    private static final double FAR_METRES = 1;
    private static final double BEHIND_METRES = 0.1;
    private static final double AROUND_METRES = 0.33;
    private static final double REACTION_SECONDS = 0.7;
    private static final double MISS_METRES = 0.08;
    private static final double MAX_SPEED = 0.35;

    private final Limbs body;
    private final Footwork feet;
    private final KickKind kind;
    private boolean waiting;
    private double walkedSeconds;

    /**
     * Creates the quick kick.
     *
     * @param body the robot
     * @param feet navigation, which makes the robot walk to positions
     */
    public Kick(Limbs body, Footwork feet) {
        this(body, feet, KickKind.QUICK);
    }

    /**
     * Creates a kick.
     *
     * @param body the robot
     * @param feet navigation, which makes the robot walk to positions
     * @param kind kind of kick
     */
    public Kick(Limbs body, Footwork feet, KickKind kind) {
        this.body = body;
        this.feet = feet;
        this.kind = kind;
    }

    /**
     * Estimates the time between the robot's arrival at the ball and the kick.
     *
     * @param world the world model
     * @param directionDegrees direction of the kick in team coordinates
     * @param kind kind of kick
     * @return time in seconds, in addition to the walk to the ball
     */
    public static double seconds(WorldModel world, double directionDegrees, KickKind kind) {
        return kind.seconds() + Footwork.aroundSeconds(world, directionDegrees);
    }

    /** Returns the required position of the ball in the robot's frame, for a kick with the foot on the side of the ball. */
    private Translation2d requiredBall(Translation2d ball) {
        Translation2d left = kind.ballOnLeft(body.nao().getType());
        return new Translation2d(left.x(), (ball.y() > 0 ? 1 : -1) * left.y());
    }

    /**
     * Approaches the ball, or kicks it if it is within reach. Call this in each cycle.
     *
     * @param world the world model
     * @param directionDegrees direction of the kick in team coordinates
     */
    public void kick(WorldModel world, double directionDegrees) {
        Translation2d ball = world.ballFromHere();
        double turn = Angles.wrap(directionDegrees - world.pose().degrees());
        double tolerance = world.opponentDistance(world.ball()) < HURRY_METRES ? HURRY : 1;
        if (waiting) {
            kickFromStance(ball, turn, tolerance);
        } else if (isThere(ball, turn, tolerance) && beyond(ball) < kind.farther() - STANCE_METRES) {
            body.walk().stop();
            waiting = true;
        } else {
            approach(world, ball, turn);
        }
    }

    /** Starts the kick as soon as the robot stands still, if the ball is still within reach. */
    private void kickFromStance(Translation2d ball, double turn, double tolerance) {
        if (body.walk().isWalking()) {
            body.walk().stop();
            walkedSeconds = body.nao().getTime();
            return;
        }
        if (body.nao().getTime() - walkedSeconds < kind.calmSeconds(body.nao().getType())) {
            return;
        }
        waiting = false;
        if (isThere(ball, turn, DRIFT * tolerance)) {
            body.motions().start(kind.motion(ball.y() > 0));
        }
    }

    private boolean isThere(Translation2d ball, double turn, double factor) {
        return beyond(ball) > -kind.nearer()
                && beyond(ball) < kind.farther()
                && Math.abs(ball.y() - requiredBall(ball).y()) < factor * kind.aside()
                && Math.abs(turn) < factor * factor * kind.turned();
    }

    /** Returns by how many metres the ball is farther ahead of the robot than required. */
    private double beyond(Translation2d ball) {
        return ball.x() - requiredBall(ball).x();
    }

    /** Walks to the position for the kick, around the ball if the robot is on the wrong side. */
    private void approach(WorldModel world, Translation2d ball, double turn) {
        Translation2d direction = Translation2d.polar(turn, 1);
        Translation2d aside = Translation2d.polar(turn + 90, 1);
        Translation2d foot = requiredBall(new Translation2d(ball.dot(direction), ball.dot(aside)));
        Translation2d place = ball.minus(direction.times(foot.x())).minus(aside.times(foot.y()));
        double ahead = ball.dot(direction);
        double miss = place.dot(aside);
        if (place.length() > FAR_METRES) {
            feet.step(world, place.minus(direction.times(BEHIND_METRES)), turn);
        } else if (ahead < 0.1) {
            double side = ball.dot(aside) <= 0 ? 1 : -1;
            feet.step(world, ball.minus(direction.times(foot.x())).plus(aside.times(side * AROUND_METRES)), turn);
        } else if (Math.abs(miss) > MISS_METRES || Math.abs(turn) > 2 * kind.turned()) {
            feet.step(world, place.minus(direction.times(BEHIND_METRES)), turn);
        } else {
            body.walk().towards(gentle(place.x() + CLOSER_METRES), gentle(place.y()), turn);
        }
    }

    private static double gentle(double metres) {
        return Math.max(-MAX_SPEED, Math.min(MAX_SPEED, metres / REACTION_SECONDS));
    }
}
