package org.robonewbie.team.skill;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.geometry.Translation2d;

/**
 * Path planner that avoids circular obstacles. Where the straight path crosses a circle, the planner tries both sides: it goes
 * to a point beside the circle and continues recursively from there. The shorter of the two paths is returned.
 *
 * <pre>{@code
 * List<Translation2d> way = PathPlanner.way(here, there, List.of(new PathPlanner.Obstacle(opponent, 0.5)));
 * walkTowards(way.get(0));
 * }</pre>
 */
public final class PathPlanner {

    private static final int MAX_TURNS = 3;
    private static final double MARGIN = 1.15;

    /**
     * A circular obstacle.
     *
     * @param centre position of the centre
     * @param radius minimum distance in metres between this position and the robot's centre
     */
    public record Obstacle(Translation2d centre, double radius) {}

    private PathPlanner() {}

    /**
     * Plans a path.
     *
     * @param from start
     * @param to target
     * @param obstacles obstacles to avoid; those that contain the target are ignored
     * @return the corners of the path, followed by its end
     */
    public static List<Translation2d> way(Translation2d from, Translation2d to, List<Obstacle> obstacles) {
        List<Obstacle> possible = obstacles.stream()
                .filter(obstacle -> obstacle.centre.distanceTo(to) > obstacle.radius)
                .toList();
        return way(from, to, possible, MAX_TURNS);
    }

    private static List<Translation2d> way(Translation2d from, Translation2d to, List<Obstacle> obstacles, int turns) {
        Optional<Obstacle> first = turns == 0 ? Optional.empty() : firstInTheWay(from, to, obstacles);
        return first.map(obstacle -> around(from, to, obstacle, obstacles, turns))
                .orElse(List.of(to));
    }

    private static Optional<Obstacle> firstInTheWay(Translation2d from, Translation2d to, List<Obstacle> obstacles) {
        return obstacles.stream()
                .filter(obstacle -> obstacle.centre.distanceToSegment(from, to)
                        < Math.min(obstacle.radius, leastDistance(from, obstacle)))
                .min(Comparator.comparingDouble(obstacle -> obstacle.centre.distanceTo(from)));
    }

    /**
     * Returns the minimum distance to keep from the centre of an obstacle. A robot inside the circle may leave it, but not get
     * closer to the centre.
     */
    private static double leastDistance(Translation2d from, Obstacle obstacle) {
        return 0.95 * from.distanceTo(obstacle.centre);
    }

    private static List<Translation2d> around(
            Translation2d from, Translation2d to, Obstacle obstacle, List<Obstacle> obstacles, int turns) {
        List<Translation2d> left = side(from, to, obstacle, 1, obstacles, turns);
        List<Translation2d> right = side(from, to, obstacle, -1, obstacles, turns);
        return length(from, left) <= length(from, right) ? left : right;
    }

    private static List<Translation2d> side(
            Translation2d from, Translation2d to, Obstacle obstacle, int side, List<Obstacle> obstacles, int turns) {
        Translation2d way = to.minus(from);
        double length = Math.max(1e-6, way.length());
        Translation2d aside = new Translation2d(-way.y(), way.x()).times(side * MARGIN * obstacle.radius / length);
        Translation2d corner = obstacle.centre.plus(aside);
        List<Translation2d> result = new ArrayList<>(way(from, corner, without(obstacles, obstacle), turns - 1));
        result.addAll(way(corner, to, obstacles, turns - 1));
        return result;
    }

    private static List<Obstacle> without(List<Obstacle> obstacles, Obstacle done) {
        return obstacles.stream().filter(obstacle -> !obstacle.equals(done)).toList();
    }

    private static double length(Translation2d from, List<Translation2d> way) {
        double sum = 0;
        Translation2d before = from;
        for (Translation2d spot : way) {
            sum += before.distanceTo(spot);
            before = spot;
        }
        return sum;
    }
}
