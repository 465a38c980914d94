package org.robonewbie.team.skill;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.team.skill.PathPlanner.Obstacle;
import org.robonewbie.team.world.Spot;

class PathPlannerTest {

    private static final Spot HERE = Spot.ORIGIN;
    private static final Spot THERE = new Spot(4, 0);

    @Test
    void goesStraightWhereNothingIsInTheWay() {
        assertThat(PathPlanner.way(HERE, THERE, List.of(new Obstacle(new Spot(2, 1), 0.5))))
                .containsExactly(THERE);
    }

    @Test
    void goesAroundOnTheShorterSide() {
        List<Spot> way = PathPlanner.way(HERE, THERE, List.of(new Obstacle(new Spot(2, 0.2), 0.5)));

        assertThat(way).hasSizeGreaterThan(1);
        assertThat(way.get(0).y()).isNegative();
        assertThat(way.get(way.size() - 1)).isEqualTo(THERE);
    }

    @Test
    void keepsAwayFromAllObstacles() {
        List<Obstacle> obstacles =
                List.of(new Obstacle(new Spot(1.5, 0.1), 0.4), new Obstacle(new Spot(2.8, -0.3), 0.4));

        Spot before = HERE;
        for (Spot bend : PathPlanner.way(HERE, THERE, obstacles)) {
            for (Obstacle obstacle : obstacles) {
                assertThat(obstacle.centre().distanceToWay(before, bend)).isGreaterThan(0.35);
            }
            before = bend;
        }
    }

    @Test
    void walksAwayFromARobotThatItTouches() {
        assertThat(PathPlanner.way(HERE, THERE, List.of(new Obstacle(new Spot(-0.3, 0), 0.5))))
                .containsExactly(THERE);
    }

    @Test
    void walksToAPlaceBesideAnObstacle() {
        assertThat(PathPlanner.way(HERE, THERE, List.of(new Obstacle(new Spot(4.2, 0), 0.5))))
                .containsExactly(THERE);
    }
}
