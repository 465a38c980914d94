package org.robonewbie.team.skill;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.PathPlanner.Obstacle;

class PathPlannerTest {

    private static final Translation2d HERE = Translation2d.ORIGIN;
    private static final Translation2d THERE = new Translation2d(4, 0);

    @Test
    void goesStraightWhereNothingIsInTheWay() {
        assertThat(PathPlanner.way(HERE, THERE, List.of(new Obstacle(new Translation2d(2, 1), 0.5))))
                .containsExactly(THERE);
    }

    @Test
    void goesAroundOnTheShorterSide() {
        List<Translation2d> way = PathPlanner.way(HERE, THERE, List.of(new Obstacle(new Translation2d(2, 0.2), 0.5)));

        assertThat(way).hasSizeGreaterThan(1);
        assertThat(way.get(0).y()).isNegative();
        assertThat(way.get(way.size() - 1)).isEqualTo(THERE);
    }

    @Test
    void keepsAwayFromAllObstacles() {
        List<Obstacle> obstacles = List.of(
                new Obstacle(new Translation2d(1.5, 0.1), 0.4), new Obstacle(new Translation2d(2.8, -0.3), 0.4));

        Translation2d before = HERE;
        for (Translation2d bend : PathPlanner.way(HERE, THERE, obstacles)) {
            for (Obstacle obstacle : obstacles) {
                assertThat(obstacle.centre().distanceToSegment(before, bend)).isGreaterThan(0.35);
            }
            before = bend;
        }
    }

    @Test
    void walksAwayFromARobotThatItTouches() {
        assertThat(PathPlanner.way(HERE, THERE, List.of(new Obstacle(new Translation2d(-0.3, 0), 0.5))))
                .containsExactly(THERE);
    }

    @Test
    void walksToAPlaceBesideAnObstacle() {
        assertThat(PathPlanner.way(HERE, THERE, List.of(new Obstacle(new Translation2d(4.2, 0), 0.5))))
                .containsExactly(THERE);
    }
}
