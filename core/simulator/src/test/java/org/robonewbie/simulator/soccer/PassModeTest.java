package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;

/** The right to pass undisturbed: when it is given, what it brings, and what it costs. */
class PassModeTest {

    @ParameterizedTest
    @CsvSource({
        "PassModeMaxBallDist=0.5, true",
        "PassModeMaxBallDist=0.3, false",
        "PassModeMaxBallSpeed=0.05, true",
        "PassModeMinOppBallDist=1, true",
        "PassModeMinOppBallDist=2, false",
        "PassModeRetryWaitTime=3, true"
    })
    void passIsGrantedOnlyNearARestingBallWithoutOpponents(String assignment, boolean granted) {
        Game game = beforePass(assignment);

        game.match.requestPass(passer(game));

        assertThat(game.playMode() == PlayMode.PASS_LEFT).isEqualTo(granted);
    }

    @ParameterizedTest
    @CsvSource({"0.05, false", "2, true"})
    void ballMustRest(double limit, boolean granted) {
        Game game = beforePass("PassModeMaxBallSpeed=" + limit);
        game.roll(0, 0, 0, 1);

        game.match.requestPass(passer(game));

        assertThat(game.playMode() == PlayMode.PASS_LEFT).isEqualTo(granted);
    }

    @Test
    void passLastsForItsTimeAndCannotBeRepeatedAtOnce() {
        Game game = beforePass("PassModeDuration=2", "PassModeRetryWaitTime=1");
        game.match.requestPass(passer(game));

        game.cycles(1.9);
        PlayMode during = game.playMode();
        game.cycles(0.2);
        PlayMode after = game.playMode();
        game.match.requestPass(passer(game));
        PlayMode tooEarly = game.playMode();
        game.cycles(1);
        game.match.requestPass(passer(game));

        assertThat(during).isEqualTo(PlayMode.PASS_LEFT);
        assertThat(after).isEqualTo(PlayMode.PLAY_ON);
        assertThat(tooEarly).isEqualTo(PlayMode.PLAY_ON);
        assertThat(game.playMode()).isEqualTo(PlayMode.PASS_LEFT);
    }

    @Test
    void opponentsArePushedAwayDuringAPass() {
        Game game = beforePass();
        game.match.requestPass(passer(game));
        Player opponent = game.match.players(TeamSide.RIGHT).get(0);

        game.put(opponent, 0.7, 0);
        game.cycle();

        assertThat(opponent.position().x()).isCloseTo(1.1, within(0.02));
    }

    @Test
    void touchEndsThePass() {
        Game game = beforePass();
        game.match.requestPass(passer(game));
        game.cycle();

        game.touch(passer(game));

        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void timeWithoutGoalsCanBeSet() {
        Game game = afterPass("PassModeScoreWaitTime=1");
        double wait = game.match.scoreWaitSeconds(TeamSide.LEFT);

        game.cycles(1.1);
        game.roll(14.8, 0, 4, 0);
        game.cycles(0.3);

        assertThat(wait).isBetween(0.5, 1.0);
        assertThat(game.playMode()).isEqualTo(PlayMode.GOAL_LEFT);
    }

    @Test
    void goalCountsEarlierWhenTwoHavePlayedTheBallAway() {
        Game game = afterPass();
        Player mate = game.join("Stars", 4);
        game.touchAndLeave(passer(game));
        game.roll(-3, 2, 0, 0);
        game.cycle();

        game.touchAndLeave(mate);
        double wait = game.match.scoreWaitSeconds(TeamSide.LEFT);
        game.roll(14.8, 0, 4, 0);
        game.cycles(0.3);

        assertThat(wait).isZero();
        assertThat(game.playMode()).isEqualTo(PlayMode.GOAL_LEFT);
    }

    @Test
    void interruptionOfTheGameLiftsTheLock() {
        Game game = afterPass();

        game.match.setPlayMode(PlayMode.KICK_IN_RIGHT);
        game.match.setPlayMode(PlayMode.PLAY_ON);

        assertThat(game.match.scoreWaitSeconds(TeamSide.LEFT)).isZero();
    }

    @Test
    void passOfTheOpponentsLiftsTheLock() {
        Game game = afterPass();
        Player opponent = game.match.players(TeamSide.RIGHT).get(0);
        game.put(passer(game), -5, 5);
        game.put(opponent, 0.4, 0);
        game.cycle();

        game.match.requestPass(opponent);
        PlayMode granted = game.playMode();
        game.match.setPlayMode(PlayMode.PLAY_ON);

        assertThat(granted).isEqualTo(PlayMode.PASS_RIGHT);
        assertThat(game.match.scoreWaitSeconds(TeamSide.LEFT)).isZero();
    }

    /** A passer beside the resting ball, 0.4 m away, and an opponent 1.5 m away. */
    private static Game beforePass(String... assignments) {
        Game game = new Game(SoccerParameters.league(), assignments);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.put(game.join("Stars", 2), -0.4, 0);
        game.put(game.join("Moons", 2), 1.5, 0);
        game.cycles(3.1);
        return game;
    }

    private static Game afterPass(String... assignments) {
        Game game = beforePass(assignments);
        game.match.requestPass(passer(game));
        game.cycles(4.1);
        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
        return game;
    }

    private static Player passer(Game game) {
        return game.match.players(TeamSide.LEFT).get(0);
    }
}
