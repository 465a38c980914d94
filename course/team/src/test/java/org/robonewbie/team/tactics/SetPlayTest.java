package org.robonewbie.team.tactics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.Agent_Team;
import org.robonewbie.team.talk.Talk;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** A free kick: for whom it waits, and who leaves the ball alone after it. A kick-off: where it goes. */
@Tag("slow")
class SetPlayTest {

    private static final Pose2d TAKER = new Pose2d(-1, 0, 0);
    private static final Pose2d MATE = new Pose2d(-2, 3, 0);

    /** Stands where it is, says so, and does not want the ball. */
    private static final class Idle extends Agent {
        @Override
        protected void think() {
            if (Talk.isMyTurn(nao.getTime(), 3)) {
                Pose2d here = new Pose2d(MATE.x(), MATE.y(), 0);
                nao.say(new TeamMessage(
                                3,
                                here,
                                false,
                                TeamRole.SUPPORTER,
                                Translation2d.ORIGIN,
                                Translation2d.ORIGIN,
                                6,
                                24,
                                0,
                                here.translation())
                        .encode());
            }
        }
    }

    @Test
    void itIsTakenWhenSomebodyIsAheadWhoCanGetTheBall() {
        try (Trial trial = freeKick(Controller.ofAgent(new Agent_Team(3)))) {
            runTo(PlayMode.PLAY_ON, trial, 14);

            assertThat(trial.now().place(1).x()).isGreaterThan(1);
        }
    }

    @Test
    void whoHasTakenItLeavesTheBallAloneUntilSomebodyElseTouchesIt() {
        try (Trial trial = freeKick(Controller.ofAgent(new Idle()))) {
            runTo(PlayMode.PLAY_ON, trial, 14);
            trial.run(trial.seconds() + 3);
            Vector3 end = trial.now().ball();
            trial.run(trial.seconds() + 9);

            assertThat(trial.now().playMode()).isEqualTo(PlayMode.PLAY_ON);
            assertThat(end.distanceTo(Vector3.ZERO)).isGreaterThan(2);
            assertThat(trial.now().ball().distanceTo(end)).isLessThan(0.3);
        }
    }

    @Test
    void kickOffGoesAsideToATeammateAndNotToTheOpponentAhead() {
        try (Trial trial = kickOff()) {
            runTo(PlayMode.PLAY_ON, trial, 14);
            trial.run(trial.seconds() + 3);
            Translation2d ball =
                    new Translation2d(trial.now().ball().x(), trial.now().ball().y());

            double teammate = ball.distanceTo(trial.now().place(1).translation());
            assertThat(teammate).isLessThan(ball.distanceTo(trial.now().place(2).translation()));
            assertThat(teammate).isLessThan(ball.distanceTo(trial.now().place(3).translation()));
            assertThat(ball.length()).isGreaterThan(3);
        }
    }

    /** Numbers 2 and 3 at their kick-off positions; opponents stand ahead at the circle and opposite the receiver. */
    private static Trial kickOff() {
        Pose2d kicker = KickOffPositions.place(2, true, true, SoccerField.LEAGUE);
        Pose2d receiver = KickOffPositions.place(3, true, true, SoccerField.LEAGUE);
        List<RobotStart> robots = List.of(
                new RobotStart("Team", 2, RobotType.TYPE_0, kicker, List.of()),
                new RobotStart("Team", 3, RobotType.TYPE_0, receiver, List.of()),
                new RobotStart("Others", 1, RobotType.TYPE_0, new Pose2d(2.5, 0, 180), List.of()),
                new RobotStart("Others", 2, RobotType.TYPE_0, new Pose2d(1.2, 3.5, 180), List.of()));
        Scene scene = new Scene(SoccerParameters.league(), true, Landscape.SOCCER, robots, Optional.of(Vector3.ZERO));
        Trial trial = Trial.served(
                scene,
                1,
                Controller.ofAgent(new Agent_Team(2)),
                Controller.ofAgent(new Agent_Team(3)),
                Controller.ofSpeeds(),
                Controller.ofSpeeds());
        trial.order(new Order.ChangePlayMode(PlayMode.KICK_OFF_LEFT));
        runTo(PlayMode.KICK_OFF_LEFT, trial, 1);
        return trial;
    }

    private static void runTo(PlayMode mode, Trial trial, double mostSeconds) {
        double last = trial.seconds() + mostSeconds;
        while (trial.now().playMode() != mode && trial.seconds() < last) {
            trial.step();
        }
        assertThat(trial.now().playMode()).isEqualTo(mode);
    }

    /** Number 2 has a free kick in the middle, number 3 is behind it; an opponent stands ahead. */
    private static Trial freeKick(Controller mate) {
        List<RobotStart> robots = List.of(
                new RobotStart("Team", 2, RobotType.TYPE_0, TAKER, List.of()),
                new RobotStart("Team", 3, RobotType.TYPE_0, MATE, List.of()),
                new RobotStart("Others", 1, RobotType.TYPE_0, new Pose2d(3.5, 0, 180), List.of()));
        Scene scene = new Scene(SoccerParameters.league(), true, Landscape.SOCCER, robots, Optional.of(Vector3.ZERO));
        Trial trial = Trial.served(scene, 1, Controller.ofAgent(new Agent_Team(2)), mate, Controller.ofSpeeds());
        trial.order(new Order.ChangePlayMode(PlayMode.FREE_KICK_LEFT));
        runTo(PlayMode.FREE_KICK_LEFT, trial, 1);
        return trial;
    }
}
