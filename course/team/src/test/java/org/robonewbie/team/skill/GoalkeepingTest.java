package org.robonewbie.team.skill;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.Agent_Team;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** What a keeper does that is alone in its goal. */
class GoalkeepingTest {

    private static final double GOAL_LINE = -SoccerParameters.beginner().field().length() / 2;
    private static final Vector3 BALL = new Vector3(GOAL_LINE + 2.5, 0.6, 0);

    @Test
    void comesOutAndStandsBetweenBallAndGoalWhileAnAttackerIsAtTheBall() {
        try (Trial trial = trial(Optional.of(new Pose2d(BALL.x() + 0.4, BALL.y(), 180)))) {
            trial.run(6);

            Vector3 keeper = trial.now().robot().position();
            Vector3 toGoal = new Vector3(GOAL_LINE - BALL.x(), -BALL.y(), 0);
            Vector3 way = toGoal.times(1 / toGoal.length());
            Vector3 seen = new Vector3(keeper.x() - BALL.x(), keeper.y() - BALL.y(), 0);
            assertThat(seen.dot(way)).isBetween(0.25, 0.6);
            assertThat(seen.minus(way.times(seen.dot(way))).length()).isLessThan(0.12);
        }
    }

    @Test
    void clearsTheBallIfNobodyElseIsThere() {
        try (Trial trial = trial(Optional.empty())) {
            double farthest = 0;
            while (trial.seconds() < 20) {
                farthest = Math.max(farthest, trial.step().ball().x() - GOAL_LINE);
            }

            assertThat(farthest).isGreaterThan(4);
        }
    }

    private static Trial trial(Optional<Pose2d> attacker) {
        List<RobotStart> robots = new ArrayList<>();
        List<Controller> controllers = new ArrayList<>();
        robots.add(new RobotStart("Team", 1, RobotType.TYPE_0, new Pose2d(GOAL_LINE + 0.25, 0, 0), List.of()));
        controllers.add(Controller.ofAgent(new Agent_Team(1)));
        attacker.ifPresent(place -> {
            robots.add(new RobotStart("Others", 2, RobotType.TYPE_0, place, List.of()));
            controllers.add(Controller.ofSpeeds());
        });
        Scene scene = new Scene(SoccerParameters.beginner(), true, Landscape.SOCCER, robots, Optional.of(BALL));
        return Trial.served(scene, 1, controllers.toArray(Controller[]::new));
    }
}
