package org.robonewbie.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** Three players against three that only stand there. */
class TeamPlaysTest {

    private static final int PLAYERS = 3;

    @Test
    @Tag("slow")
    void threePlayersScoreAgainstThreeThatDoNothing() {
        try (Trial trial = match(1)) {
            WorldState last = trial.now();
            while (trial.seconds() < 90 && last.leftGoals() == 0) {
                last = trial.step();
            }

            assertThat(last.leftGoals()).isEqualTo(1);
            assertThat(last.rightGoals()).isZero();
        }
    }

    @Test
    @Tag("slow")
    void sameSeedIsTheSameGame() {
        assertThat(after(6, 5)).isEqualTo(after(6, 5));
    }

    @Test
    @Tag("slow")
    void onlyOnePlayerGoesToTheBallAndAllSpeakInTheirTurn() {
        try (Trial trial = match(2)) {
            int[] said = new int[PLAYERS];
            for (int cycle = 0; cycle < 250; cycle++) {
                trial.step();
                for (int i = 0; i < PLAYERS; i++) {
                    said[i] += trial.said(i).flatMap(TeamMessage::decode).isPresent() ? 1 : 0;
                }
            }

            assertThat(IntStream.of(said).boxed().toList()).isSubsetOf(250 / 22, 250 / 22 + 1);
            assertThat(nearBall(trial.now())).isLessThanOrEqualTo(1);
        }
    }

    private static int nearBall(WorldState now) {
        return (int) now.robots().subList(0, PLAYERS).stream()
                .filter(robot -> robot.position().distanceTo(now.ball()) < 0.8)
                .count();
    }

    private static List<Vector3> after(long seed, double seconds) {
        try (Trial trial = match(seed)) {
            trial.run(seconds);
            WorldState end = trial.now();
            List<Vector3> places = new ArrayList<>(List.of(end.ball()));
            end.robots().forEach(robot -> places.add(robot.position()));
            return places;
        }
    }

    private static Trial match(long seed) {
        List<RobotStart> robots = new ArrayList<>();
        List<Controller> controllers = new ArrayList<>();
        for (int number = 1; number <= PLAYERS; number++) {
            Pose2d place = number == 1 ? new Pose2d(-14, 0, 0) : new Pose2d(5.5 + number, 3.0 * number - 7.5, 0);
            robots.add(new RobotStart("Team", number, RobotType.TYPE_0, place, List.of()));
            controllers.add(Controller.ofAgent(new Agent_Team(number)));
        }
        for (int number = 1; number <= PLAYERS; number++) {
            robots.add(new RobotStart(
                    "Others", number, RobotType.TYPE_0, new Pose2d(12, 3.0 * number - 7.5, 180), List.of()));
            controllers.add(Controller.ofSpeeds());
        }
        Scene scene =
                new Scene(SoccerParameters.league(), true, Landscape.SOCCER, robots, Optional.of(new Vector3(9, 0, 0)));
        return Trial.served(scene, seed, controllers.toArray(Controller[]::new));
    }
}
