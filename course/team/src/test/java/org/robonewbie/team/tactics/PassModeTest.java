package org.robonewbie.team.tactics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.world.Situation;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** What the referee answers to a robot that asks for pass mode. */
class PassModeTest {

    /** Asks all the time. */
    private static final class Asking extends Agent {
        @Override
        protected void think() {
            nao.requestPass();
        }
    }

    @Test
    void aRobotAtTheBallGetsPassModeForFourSeconds() {
        try (Trial trial = trial(0.4, 2)) {
            assertThat(modeAfter(trial, 1)).isEqualTo(PlayMode.PASS_LEFT);
            assertThat(modeAfter(trial, 3.5)).isEqualTo(PlayMode.PASS_LEFT);
            assertThat(modeAfter(trial, 4.5)).isEqualTo(PlayMode.PLAY_ON);
        }
    }

    @Test
    void aRobotFarFromTheBallGetsNothing() {
        try (Trial trial = trial(0.7, 2)) {
            assertThat(modeAfter(trial, 1)).isEqualTo(PlayMode.PLAY_ON);
        }
    }

    @Test
    void withAnOpponentAtTheBallItIsTooLate() {
        try (Trial trial = trial(0.4, 0.8)) {
            assertThat(modeAfter(trial, 1)).isEqualTo(PlayMode.PLAY_ON);
        }
    }

    @Test
    void onlyTheOtherTeamHasToKeepAway() {
        assertThat(Situation.of(PlayMode.PASS_LEFT, TeamSide.LEFT)).isEqualTo(Situation.OUR_PASS);
        assertThat(Situation.of(PlayMode.PASS_LEFT, TeamSide.RIGHT)).isEqualTo(Situation.THEIR_KICK);
        assertThat(Situation.OUR_PASS.isOpen()).isTrue();
        assertThat(Situation.OUR_PASS.isOurs()).isFalse();
    }

    /** The play mode so many seconds after the beginning. */
    private static PlayMode modeAfter(Trial trial, double seconds) {
        trial.run(seconds);
        WorldState now = trial.now();
        return now.playMode();
    }

    private static Trial trial(double robotMetres, double opponentMetres) {
        List<RobotStart> robots = List.of(
                new RobotStart("Team", 1, RobotType.TYPE_0, new Pose2d(-robotMetres, 0, 0), List.of()),
                new RobotStart("Others", 1, RobotType.TYPE_0, new Pose2d(opponentMetres, 0, 180), List.of()));
        Scene scene = new Scene(SoccerParameters.league(), true, Landscape.SOCCER, robots, Optional.of(Vector3.ZERO));
        return Trial.served(scene, 1, Controller.ofAgent(new Asking()), Controller.ofSpeeds());
    }
}
