package org.robonewbie.team.skill;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.PathPlanner.Obstacle;
import org.robonewbie.team.world.Abilities;
import org.robonewbie.team.world.Mate;
import org.robonewbie.team.world.WorldModel;

/**
 * Navigation to target poses. The robot approaches a distant target as a pedestrian would: it turns towards the target and
 * walks forward, avoiding all other robots. The last steps may be sideways or backward, while it turns to the final heading.
 */
public final class Footwork {

    /** The players' walking style: fast when walking forward, with turns and accelerations limited to avoid falls. */
    public static final WalkStyle STYLE = WalkStyle.FAST.withLimits(
            new WalkVelocity(0.69, 0.2, 120), WalkStyle.FAST.backward(), new WalkVelocity(0.13, 0.085, 19));

    private static final double FAST = STYLE.most().forward();
    private static final double AROUND_DEGREES_PER_SECOND = 25;
    private static final double NEAR_METRES = 0.7;
    private static final double SLOW = 0.3;
    private static final double CALM = 0.6;
    private static final double CLOSE_METRES = 0.8;
    private static final double CLOSE_DEGREES = 40;
    private static final double JOG_ROOM_METRES = 1.6;
    private static final double JOG_ASIDE_METRES = 0.5;
    private static final double FAR_METRES = 0.55;
    private static final double ARRIVED_DEGREES = 12;
    private static final double LEFT_METRES = 0.4;
    private static final double EXACT_METRES = 0.05;
    private static final double EXACT_DEGREES = 8;
    private static final double AHEAD_DEGREES = 45;
    private static final double SIGHT_METRES = 3;
    private static final double FAR_TURN = 1.6;
    private static final double NEAR_TURN = 1.2;
    private static final double NEAR_SPEED = 1.8;

    private final Walk walk;
    private final Optional<Jog> jog;
    private boolean standing;

    /**
     * Creates the navigation of a robot that only walks.
     *
     * @param walk the walk
     */
    public Footwork(Walk walk) {
        this(walk, false);
    }

    /**
     * Creates the navigation.
     *
     * @param walk the walk
     * @param jogs whether the robot jogs on long ways; then {@link #STYLE} must be selected again in each cycle
     */
    public Footwork(Walk walk, boolean jogs) {
        this.walk = walk;
        this.jog = jogs ? Optional.of(new Jog(walk)) : Optional.empty();
    }

    /**
     * Walks to a pose, avoiding all other robots, and stops there. At maximum speed, even an undisturbed robot stumbles
     * about once every two minutes. In a small team no other player can take over, so its players walk more slowly.
     *
     * @param world the world model
     * @param place target in team coordinates
     * @param headingDegrees final heading in team coordinates
     * @return the path, for use in drawings
     */
    public List<Translation2d> go(WorldModel world, Translation2d place, double headingDegrees) {
        List<Translation2d> way = PathPlanner.way(world.place(), place, others(world));
        Translation2d next = way.get(0).seenFrom(world.pose());
        double turn = Angles.wrap(headingDegrees - world.pose().degrees());
        double arrived = world.abilities().arrivedMetres();
        double tolerance = standing ? Math.max(LEFT_METRES, 2 * arrived) : arrived;
        double turnTolerance = standing ? 2 * ARRIVED_DEGREES : ARRIVED_DEGREES;
        standing = way.size() == 1 && next.length() < tolerance && Math.abs(turn) < turnTolerance;
        if (standing) {
            walk.stop();
        } else if (!jogs(world, next, world.place().distanceTo(place))) {
            step(world, next, turn, way.size() == 1, pace(world));
        }
        return way;
    }

    private boolean jogs(WorldModel world, Translation2d next, double metres) {
        return world.abilities().movesLegs()
                && jog.isPresent()
                && jog.get().go(world, next, metres, others(world).stream().noneMatch(other -> {
                    Translation2d place = other.centre().seenFrom(world.pose());
                    return place.x() > 0 && place.x() < JOG_ROOM_METRES && Math.abs(place.y()) < JOG_ASIDE_METRES;
                }));
    }

    private static double pace(WorldModel world) {
        return world.isSmallTeam() ? Math.min(CALM, speed(world)) : speed(world);
    }

    /**
     * Follows a moving target closely: in situations in which {@link #go} would stand still, the robot takes small steps.
     *
     * @param world the world model
     * @param place target in team coordinates
     * @param headingDegrees heading in team coordinates
     */
    public void shadow(WorldModel world, Translation2d place, double headingDegrees) {
        Translation2d next = place.seenFrom(world.pose());
        double turn = Angles.wrap(headingDegrees - world.pose().degrees());
        standing = next.length() < EXACT_METRES && Math.abs(turn) < EXACT_DEGREES;
        if (standing) {
            walk.stop();
        } else {
            step(world, next, turn);
        }
    }

    /**
     * Walks towards a point near the ball without stopping there; on the way to a distant point, it avoids all other robots.
     *
     * @param world the world model
     * @param place target in the robot's frame
     * @param turnDegrees angle by which to turn if the target is near
     */
    public void step(WorldModel world, Translation2d place, double turnDegrees) {
        if (place.length() > FAR_METRES) {
            List<Translation2d> way = PathPlanner.way(world.place(), place.onMap(world.pose()), others(world));
            Translation2d next = way.get(0).seenFrom(world.pose());
            if (!jogs(world, next, place.length())) {
                step(world, next, turnDegrees, false, speed(world));
            }
        } else {
            step(world, place, turnDegrees, true, speed(world));
        }
    }

    private void step(WorldModel world, Translation2d place, double turnDegrees, boolean last, double pace) {
        Abilities abilities = world.abilities();
        double bearing = place.degrees();
        if (!last || place.length() > (abilities.movesLegs() ? FAR_METRES : abilities.arrivedMetres())) {
            boolean ahead = Math.abs(bearing) < AHEAD_DEGREES;
            walk.towards(ahead ? pace : 0, 0, FAR_TURN * bearing);
        } else if (!abilities.movesLegs()) {
            walk.towards(0, 0, NEAR_TURN * turnDegrees);
        } else {
            walk.towards(Math.min(pace, NEAR_SPEED * place.x()), NEAR_SPEED * place.y(), NEAR_TURN * turnDegrees);
        }
    }

    /**
     * Returns the maximum forward speed: low if another robot is close ahead, because running into an opponent is a foul and
     * makes both robots fall.
     *
     * @param world the world model
     * @return speed in metres per second
     */
    public static double speed(WorldModel world) {
        boolean blocked = Stream.concat(
                        world.opponents().stream(), world.mates().stream().map(Mate::place))
                .map(place -> place.seenFrom(world.pose()))
                .anyMatch(place -> place.length() < CLOSE_METRES && Math.abs(place.degrees()) < CLOSE_DEGREES);
        return blocked ? SLOW : FAST;
    }

    /**
     * Estimates the additional time that the robot needs to walk around the ball to the side opposite its target. This time
     * is short if the robot is far away, because the detour is small.
     *
     * @param world the world model
     * @param directionDegrees intended direction of the ball in team coordinates
     * @return time in seconds, in addition to the walk to the ball
     */
    public static double aroundSeconds(WorldModel world, double directionDegrees) {
        Translation2d way = world.ball().minus(world.place());
        double around = Math.abs(Angles.wrap(directionDegrees - way.degrees()));
        return around / AROUND_DEGREES_PER_SECOND * Math.min(1, NEAR_METRES / Math.max(0.1, way.length()));
    }

    /**
     * Returns the obstacles for path planning.
     *
     * @param world the world model
     * @return the robots in sight, as obstacles
     */
    public static List<Obstacle> others(WorldModel world) {
        List<Obstacle> obstacles = new ArrayList<>();
        double metres = world.abilities().robotMetres();
        world.opponents().forEach(place -> obstacles.add(new Obstacle(place, metres)));
        world.mates().stream().map(Mate::place).forEach(place -> obstacles.add(new Obstacle(place, metres)));
        obstacles.removeIf(obstacle -> obstacle.centre().distanceTo(world.place()) > SIGHT_METRES);
        return obstacles;
    }
}
