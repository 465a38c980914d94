package org.robonewbie.team.skill;

import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Fast dribbling. The robot gets behind the ball, as seen from the target, and keeps walking, so that its feet push the ball
 * along. It never stops as long as the ball stays on the path.
 *
 * <p>While the ball is in a cone with its apex between the feet, the robot walks on and only corrects its course; otherwise
 * it walks around the ball. If an opponent is near and the ball is ahead, it does not correct its course but walks straight
 * through the ball.
 *
 * <p>A swinging foot is more than twice as fast as the robot, and a ball that it hits at more than 0.8 m/s bounces off and may
 * roll a metre ahead. That does no harm when no opponent is near. {@link CloseDribble} keeps the ball closer.
 */
public final class Dribble {

    private static final double CONTESTED_METRES = 1;
    private static final double CHARGE_DEGREES = 45;
    private static final double CHARGE_METRES = 0.5;
    private static final double CONE_METRES = 0.07;
    private static final double CONE_SLOPE = 0.22;
    private static final double BEHIND_METRES = 0.25;
    private static final double WIDE_CONE_METRES = 0.3;
    private static final double CALM_METRES = 0.02;
    private static final double CALM_DEGREES = 3;
    private static final double TURN = 1.5;
    private static final double MIN_SECONDS = 0.5;
    private static final double AHEAD_SECONDS = 0.25;

    private final Walk walk;
    private final Footwork feet;

    /**
     * Creates the skill.
     *
     * @param walk the walk
     * @param feet navigation, which makes the robot walk to positions
     */
    public Dribble(Walk walk, Footwork feet) {
        this.walk = walk;
        this.feet = feet;
    }

    /**
     * Dribbles towards a target; the ball may roll a metre ahead. Call this in each cycle.
     *
     * @param world the world model
     * @param target where to take the ball, in team coordinates
     */
    public void bring(WorldModel world, Translation2d target) {
        Translation2d ball = world.ballIn(AHEAD_SECONDS).seenFrom(world.pose());
        BallOnWay way = BallOnWay.of(world, ball, world.ball(), target);
        if (!world.abilities().movesLegs()) {
            pushWithoutSideSteps(world, way);
        } else if (isContested(world) && isAhead(ball) && Math.abs(way.turn()) < CHARGE_DEGREES) {
            charge(world, way);
        } else if (way.isInCone(CONE_METRES, CONE_SLOPE)) {
            push(world, way);
        } else {
            way.getBehind(feet, world);
        }
    }

    /** Aims at a point behind the ball, so that a robot that is beside the path curves back to it. */
    private void pushWithoutSideSteps(WorldModel world, BallOnWay way) {
        if (way.isInCone(WIDE_CONE_METRES, CONE_SLOPE, CHARGE_DEGREES)) {
            Translation2d aim =
                    way.ball().minus(Translation2d.polar(way.turn(), way.ball().length() / 2));
            walk.towards(Footwork.speed(world), 0, TURN * aim.degrees());
        } else {
            way.getBehind(feet, world);
        }
    }

    private static boolean isAhead(Translation2d ball) {
        return ball.length() < CHARGE_METRES && Math.abs(ball.degrees()) < CHARGE_DEGREES;
    }

    private static boolean isContested(WorldModel world) {
        return world.opponentDistance(world.ball()) < CONTESTED_METRES;
    }

    /**
     * Walks straight through the ball without getting behind it first, because an opponent would take the ball in the meantime.
     */
    private void charge(WorldModel world, BallOnWay way) {
        walk.towards(Footwork.speed(world), 0, (way.ball().degrees() + way.turn()) / 2);
    }

    private void push(WorldModel world, BallOnWay way) {
        double speed = Footwork.speed(world);
        double seconds = Math.max(MIN_SECONDS, (way.ahead() - BEHIND_METRES) / speed);
        double aside = BallOnWay.beyond(way.aside(), CALM_METRES);
        walk.towards(speed, -aside / seconds, TURN * BallOnWay.beyond(way.turn(), CALM_DEGREES));
    }
}
