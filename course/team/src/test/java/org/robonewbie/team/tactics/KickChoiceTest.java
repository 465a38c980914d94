package org.robonewbie.team.tactics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.tactics.Plan.Action;
import org.robonewbie.team.world.WorldModel;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** When a player kicks far, and that an opponent in the way makes no kick better. */
class KickChoiceTest {

    private static final double GOAL_LINE = 15;

    /** Stands, looks at the ball, and says what it would do. */
    private static final class Choosing extends Agent {

        private final WorldModel world = new WorldModel();
        private final Gaze gaze = new Gaze(new Limbs(nao, walk, motions, lookAround));
        private final boolean mayScore;

        Choosing(boolean mayScore) {
            this.mayScore = mayScore;
            fieldView.setTransformation(CameraTransformation.KINEMATICS);
        }

        @Override
        protected void think() {
            world.update(nao, fieldView);
            gaze.look(world);
        }

        Plan best() {
            return new KickChoice(world, true, mayScore, Plan.NONE).best();
        }

        double gainOfKick(double degrees) {
            return new KickChoice(world, true, mayScore, Plan.NONE)
                    .options().stream()
                            .filter(option -> option.plan().action() == Action.KICK)
                            .filter(option -> option.plan().headingDegrees() == degrees)
                            .mapToDouble(KickChoice.Option::gain)
                            .findFirst()
                            .orElseThrow();
        }
    }

    @Test
    void itShootsFarOverTheHeadOfAnOpponent() {
        Plan plan = choice(new Choosing(true), RobotType.TYPE_0, 10, 3);

        assertThat(plan.action()).isEqualTo(Action.FAR_KICK);
        assertThat(plan.headingDegrees()).isBetween(-6.0, 6.0);
        assertThat(plan.target().x()).isGreaterThan(GOAL_LINE);
    }

    @Test
    void itDoesNotShootOverTheBar() {
        Plan plan = choice(new Choosing(true), RobotType.TYPE_0, 6, 3);

        assertThat(plan.action()).isNotEqualTo(Action.FAR_KICK);
    }

    @Test
    void itDoesNotShootWhereAGoalWouldNotCount() {
        Plan plan = choice(new Choosing(false), RobotType.TYPE_0, 10, 3);

        assertThat(plan.target().x()).isLessThan(GOAL_LINE);
    }

    @Test
    void aRobotWithToesKicksAsUsual() {
        Plan plan = choice(new Choosing(true), RobotType.TYPE_4, 10, 3);

        assertThat(plan.action()).isNotEqualTo(Action.FAR_KICK);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -180})
    void anOpponentInTheWayMakesNoKickBetter(double degrees) {
        double blocked = gainOfKick(degrees, degrees);
        double free = gainOfKick(degrees, degrees + 50);

        assertThat(blocked).isLessThan(free);
    }

    /** What a kick gains that a player could make straight ahead, with an opponent two metres from the ball. */
    private static double gainOfKick(double degrees, double opponentDegrees) {
        Choosing player = new Choosing(true);
        Translation2d ball = new Translation2d(-6, 0);
        Translation2d place = ball.minus(Translation2d.polar(degrees, 0.3));
        Translation2d opponent = ball.plus(Translation2d.polar(opponentDegrees, 2));
        decide(
                player,
                RobotType.TYPE_0,
                new Pose2d(place.x(), place.y(), degrees),
                ball,
                new Pose2d(opponent.x(), opponent.y(), 0));
        return player.gainOfKick(degrees);
    }

    /** What a player does whose ball lies before its feet, with an opponent ahead of it. */
    private static Plan choice(Choosing player, RobotType type, double goalMetres, double opponentMetres) {
        double x = GOAL_LINE - goalMetres;
        Pose2d opponent = new Pose2d(x + opponentMetres, 0, 180);
        decide(player, type, new Pose2d(x - 0.3, 0, 0), new Translation2d(x, 0), opponent);
        return player.best();
    }

    /** Lets a player look at the ball and an opponent for a while. */
    private static void decide(Choosing player, RobotType type, Pose2d place, Translation2d ball, Pose2d opponent) {
        List<RobotStart> robots = List.of(
                new RobotStart("Team", 2, type, place, List.of()),
                new RobotStart("Others", 2, RobotType.TYPE_0, opponent, List.of()));
        Scene scene = new Scene(
                SoccerParameters.league(),
                true,
                Landscape.SOCCER,
                robots,
                Optional.of(new Vector3(ball.x(), ball.y(), 0)));
        try (Trial trial = Trial.served(scene, 1, Controller.ofAgent(player), Controller.ofSpeeds())) {
            trial.run(1.5);
        }
    }
}
