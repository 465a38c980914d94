package org.robonewbie.team.skill;

import org.robonewbie.agent.walk.Walk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Dribbling with close control: the ball stays within half a metre most of the time. It requires its own walking style:
 *
 * <pre>{@code
 * walk.setStyle(CloseDribble.STYLE);    // before the robot begins to walk
 * dribble.bring(world, target);         // in each cycle
 * }</pre>
 *
 * <p>Each foot is on the ground half the time, so it swings at least twice as fast as the robot walks. A ball that a foot
 * hits at more than 0.8 m/s bounces off. Three measures keep the ball close:
 * <ul>
 * <li>The feet swing at as constant a speed as the motors allow, so a foot never moves at much more than twice the speed of
 * the robot ({@link #STYLE}).
 * <li>The robot walks slowly enough to brake before a foot hits the ball, so that the foot hits the ball at about 0.8 m/s.
 * A ball that is rolling away may be hit at a higher speed.
 * <li>When the ball is rolling away, the robot follows it faster than it would approach a resting ball.
 * </ul>
 */
public final class CloseDribble {

    /** Walking style with even foot swings; as fast as {@link Footwork#STYLE}, but less stable. */
    public static final WalkStyle STYLE = CloseDribbleNumbers.FOUND.style();

    private static final double CONE_METRES = 0.12;
    private static final double CONE_SLOPE = 0.38;
    private static final double LOOK_SECONDS = 0.05;

    private final Walk walk;
    private final Footwork feet;
    private final CloseDribbleNumbers numbers;

    /**
     * Creates the skill.
     *
     * @param walk the walk, with {@link #STYLE}
     * @param feet navigation, which makes the robot walk to positions
     */
    public CloseDribble(Walk walk, Footwork feet) {
        this(walk, feet, CloseDribbleNumbers.FOUND);
    }

    /**
     * Creates the skill with the given parameters, for a parameter search.
     *
     * @param walk the walk; its style must be the one in {@code numbers}
     * @param feet navigation, which makes the robot walk to positions
     * @param numbers parameters of the skill
     */
    public CloseDribble(Walk walk, Footwork feet, CloseDribbleNumbers numbers) {
        this.walk = walk;
        this.feet = feet;
        this.numbers = numbers;
    }

    /**
     * Dribbles towards a target. Call this in each cycle.
     *
     * @param world the world model
     * @param target where to take the ball, in team coordinates
     */
    public void bring(WorldModel world, Translation2d target) {
        Translation2d now = world.ballAtFeetIn(0).onMap(world.pose());
        BallOnWay way = BallOnWay.of(world, world.ballAtFeetIn(numbers.aheadSeconds()), now, target);
        if (way.isInCone(CONE_METRES, CONE_SLOPE)) {
            push(world, way);
        } else {
            way.getBehind(feet, world);
        }
    }

    private void push(WorldModel world, BallOnWay way) {
        double speed = Math.min(Footwork.speed(world), numbers.speed(way.ahead(), rolling(world, way)));
        double aside = BallOnWay.beyond(way.aside(), numbers.calmMetres());
        double turn = numbers.turn() * BallOnWay.beyond(way.turn(), numbers.calmDegrees())
                + numbers.ballTurn() * way.ball().degrees();
        walk.towards(speed, -aside / numbers.seconds(way.ahead(), speed), turn);
    }

    /** Returns the speed of the ball along the path in metres per second; 0 if it rolls back towards the robot. */
    private static double rolling(WorldModel world, BallOnWay way) {
        Translation2d rolled = world.ballAtFeetIn(LOOK_SECONDS).minus(world.ballAtFeetIn(0));
        return Math.max(0, rolled.dot(Translation2d.polar(way.turn(), 1))) / LOOK_SECONDS;
    }
}
