package org.robonewbie.team.tactics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;
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

/** Where a player waits for a pass. */
class ReceiverTest {

    private static final Translation2d BALL = new Translation2d(-3, 0);
    private static final Translation2d END = new Translation2d(1, 2);

    /** Stands at the ball and says that it is about to pass to number 2. */
    private static final class Passing extends Agent {
        @Override
        protected void think() {
            if (Talk.isMyTurn(nao.getTime(), 1)) {
                Pose2d here = new Pose2d(BALL.x() - 0.4, BALL.y(), 0);
                nao.say(new TeamMessage(1, here, false, TeamRole.STRIKER, BALL, Translation2d.ORIGIN, 0, 0.5, 2, END)
                        .encode());
            }
        }
    }

    @Tag("slow")
    @Test
    void itStandsBehindTheEndOfThePassAndDoesNotTurnItsBackToTheGoal() {
        try (Trial trial = trial()) {
            trial.run(8);
            Pose2d receiver = trial.now().place(1);

            assertThat(receiver.x()).isBetween(END.x() - 0.8, END.x() - 0.1);
            assertThat(receiver.distance(new Vector3(END.x(), END.y(), 0))).isBetween(0.3, 0.9);
            assertThat(Math.abs(receiver.degrees())).isLessThan(120);
        }
    }

    private static Trial trial() {
        List<RobotStart> robots = List.of(
                new RobotStart("Team", 1, RobotType.TYPE_0, new Pose2d(BALL.x() - 0.4, BALL.y(), 0), List.of()),
                new RobotStart("Team", 2, RobotType.TYPE_0, new Pose2d(2, 2, 180), List.of()));
        Vector3 ball = new Vector3(BALL.x(), BALL.y(), 0);
        Scene scene = new Scene(SoccerParameters.league(), true, Landscape.SOCCER, robots, Optional.of(ball));
        return Trial.served(scene, 1, Controller.ofAgent(new Passing()), Controller.ofAgent(new Agent_Team(2)));
    }
}
