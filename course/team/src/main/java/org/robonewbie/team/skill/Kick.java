package org.robonewbie.team.skill;

import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Kicks the ball far. The kick is a motion of keyframes that begins in the stance, with the ball before a foot. So the robot walks
 * there, stops, looks whether the ball lies within reach, and only then kicks; else it goes on walking. With an opponent near it is
 * content with less, but not ahead: a ball that touches the foot already rolls two metres only, one that is too far ahead rolls one.
 * When the robot stops it takes its last step back a little, so it stops only where the ball will still be near enough then.
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
     * Prepares the usual kick, which takes little time.
     *
     * @param body walks and kicks
     * @param feet walks to places
     */
    public Kick(Limbs body, Footwork feet) {
        this(body, feet, KickKind.QUICK);
    }

    /**
     * Prepares a kick.
     *
     * @param body walks and kicks
     * @param feet walks to places
     * @param kind what is done with the ball
     */
    public Kick(Limbs body, Footwork feet, KickKind kind) {
        this.body = body;
        this.feet = feet;
        this.kind = kind;
    }

    /**
     * Estimates how long it takes until the ball is on its way, for a robot that is at the ball.
     *
     * @param world where the ball is
     * @param directionDegrees where the ball has to go, in the coordinates of the team
     * @param kind how it is kicked
     * @return seconds, without the way to the ball
     */
    public static double seconds(WorldModel world, double directionDegrees, KickKind kind) {
        return kind.seconds() + Footwork.aroundSeconds(world, directionDegrees);
    }

    /** Where the ball has to lie for the kick with the foot that suits the side on which it is. */
    private Translation2d before(Translation2d ball) {
        Translation2d left = kind.ballOnLeft(body.nao().getType());
        return new Translation2d(left.x(), (ball.y() > 0 ? 1 : -1) * left.y());
    }

    /**
     * Comes one step nearer to the kick, or kicks.
     *
     * @param world where the ball is
     * @param directionDegrees where the ball has to go, in the coordinates of the team
     */
    public void kick(WorldModel world, double directionDegrees) {
        Translation2d ball = world.ballFromHere();
        double turn = Angles.wrap(directionDegrees - world.pose().degrees());
        double patience = world.opponentDistance(world.ball()) < HURRY_METRES ? HURRY : 1;
        if (waiting) {
            waitForTheStance(ball, turn, patience);
        } else if (isThere(ball, turn, patience) && beyond(ball) < kind.farther() - STANCE_METRES) {
            body.walk().stop();
            waiting = true;
        } else {
            approach(world, ball, turn);
        }
    }

    /** Kicks as soon as the robot stands, if the ball is within reach then. */
    private void waitForTheStance(Translation2d ball, double turn, double patience) {
        if (body.walk().isWalking()) {
            body.walk().stop();
            walkedSeconds = body.nao().getTime();
            return;
        }
        if (body.nao().getTime() - walkedSeconds < kind.calmSeconds(body.nao().getType())) {
            return;
        }
        waiting = false;
        if (isThere(ball, turn, DRIFT * patience)) {
            body.motions().start(kind.motion(ball.y() > 0));
        }
    }

    private boolean isThere(Translation2d ball, double turn, double factor) {
        return beyond(ball) > -kind.nearer()
                && beyond(ball) < kind.farther()
                && Math.abs(ball.y() - before(ball).y()) < factor * kind.aside()
                && Math.abs(turn) < factor * factor * kind.turned();
    }

    /** How much too far away the ball lies, metres. */
    private double beyond(Translation2d ball) {
        return ball.x() - before(ball).x();
    }

    /** Walks to the place from which the ball lies before the foot; from the wrong side of the ball around it. */
    private void approach(WorldModel world, Translation2d ball, double turn) {
        Translation2d direction = Translation2d.polar(turn, 1);
        Translation2d aside = Translation2d.polar(turn + 90, 1);
        Translation2d foot = before(new Translation2d(ball.dot(direction), ball.dot(aside)));
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
