package org.robonewbie.team.skill;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.team.skill.PathPlanner.Obstacle;
import org.robonewbie.team.world.Mate;
import org.robonewbie.team.world.Spot;
import org.robonewbie.team.world.WorldModel;

/**
 * Walks to places. To a far one the robot goes as people do: it turns and walks straight ahead, around all others. The last steps it
 * goes sideways or backward, and turns meanwhile as it wants to stand in the end.
 */
public final class Footwork {

    private static final double FAR_METRES = 0.9;
    private static final double ARRIVED_METRES = 0.12;
    private static final double ARRIVED_DEGREES = 12;
    private static final double LEFT_METRES = 0.4;
    private static final double ROBOT_METRES = 0.5;
    private static final double AHEAD_DEGREES = 40;
    private static final double SIGHT_METRES = 3;

    private final Walk walk;
    private boolean standing;

    /**
     * Prepares the feet.
     *
     * @param walk the walk
     */
    public Footwork(Walk walk) {
        this.walk = walk;
    }

    /**
     * Walks to a place around all other robots, and stops there.
     *
     * @param world where the others are
     * @param place where to, in the coordinates of the team
     * @param headingDegrees which way to face there, in the coordinates of the team
     * @return the way, for a drawing
     */
    public List<Spot> go(WorldModel world, Spot place, double headingDegrees) {
        List<Spot> way = PathPlanner.way(world.place(), place, others(world));
        Spot next = way.get(0).seenFrom(world.pose());
        double turn = PortableMath.IEEEremainder(headingDegrees - world.pose().headingDegrees(), 360);
        double tolerance = standing ? LEFT_METRES : ARRIVED_METRES;
        double turnTolerance = standing ? 2 * ARRIVED_DEGREES : ARRIVED_DEGREES;
        standing = way.size() == 1 && next.length() < tolerance && Math.abs(turn) < turnTolerance;
        if (standing) {
            walk.stop();
        } else {
            step(next, turn, way.size() == 1);
        }
        return way;
    }

    /**
     * Walks towards a place without stopping there.
     *
     * @param place where to, seen from the robot
     * @param turnDegrees how far to turn meanwhile, if the place is near
     * @param last whether the way ends there
     */
    public void step(Spot place, double turnDegrees, boolean last) {
        double bearing = place.degrees();
        if (!last || place.length() > FAR_METRES) {
            boolean ahead = Math.abs(bearing) < AHEAD_DEGREES;
            walk.towards(ahead ? Walk.MOST_FORWARD : 0, 0, 1.5 * bearing);
        } else {
            walk.towards(1.5 * place.x(), 1.5 * place.y(), 1.5 * turnDegrees);
        }
    }

    /**
     * Lists what to walk around.
     *
     * @param world where the others are
     * @return robots in sight
     */
    public static List<Obstacle> others(WorldModel world) {
        List<Obstacle> obstacles = new ArrayList<>();
        world.opponents().forEach(place -> obstacles.add(new Obstacle(place, ROBOT_METRES)));
        world.mates().stream().map(Mate::place).forEach(place -> obstacles.add(new Obstacle(place, ROBOT_METRES)));
        obstacles.removeIf(obstacle -> obstacle.centre().distanceTo(world.place()) > SIGHT_METRES);
        return obstacles;
    }
}
