package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;

class PlayModesTest {

    private final Game game = new Game(SoccerParameters.league());

    @Test
    void leagueDoesNotKickOffAutomatically() {
        game.join("Stars", 1);

        game.cycles(40);

        assertThat(game.playMode()).isEqualTo(PlayMode.BEFORE_KICK_OFF);
        assertThat(game.match.state().playSeconds()).isZero();
    }

    @Test
    void beginnersKickOffInTheFirstCycle() {
        Game beginners = new Game(SoccerParameters.beginner());
        beginners.join("Stars", 1);

        beginners.cycle();

        assertThat(beginners.playMode()).isEqualTo(PlayMode.KICK_OFF_LEFT);
    }

    @Test
    void robotsAreKeptInTheirOwnHalfBeforeKickOff() {
        Player player = game.join("Stars", 1);
        game.put(player, 3, 1);

        game.cycle();

        assertThat(player.position().x()).isCloseTo(-2.5, within(0.05));
        assertThat(player.position().y()).isCloseTo(1, within(0.05));
    }

    @Test
    void kickOffEndsWithTheFirstTouch() {
        Player player = game.join("Stars", 1);
        game.match.kickOff(TeamSide.LEFT);

        game.touch(player);

        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void offsideIsNotJudgedWhateverTheParameterSays() {
        Game strict = new Game(SoccerParameters.league().with("UseOffside=true"));
        Player striker = strict.join("Stars", 2);
        strict.put(strict.join("Moons", 2), -5, 3);
        strict.match.setPlayMode(PlayMode.PLAY_ON);
        strict.roll(10, 2, 0, 0);

        strict.touch(striker);
        strict.cycles(1);

        assertThat(strict.playMode()).isEqualTo(PlayMode.PLAY_ON);
        assertThat(strict.match.fouls()).isEmpty();
    }

    @Test
    void opponentsLeaveTheCentreCircleAtKickOff() {
        game.join("Stars", 1);
        Player opponent = game.join("Moons", 1);
        game.put(opponent, 1, 0.5);

        game.match.kickOff(TeamSide.LEFT);
        game.cycle();

        assertThat(opponent.position().x()).isCloseTo(2.5, within(0.05));
    }

    @Test
    void ballInTheGoalCounts() {
        Player player = game.join("Stars", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.touchAndLeave(player);

        game.roll(14.8, 0.3, 4, 0);
        game.cycles(0.3);

        assertThat(game.playMode()).isEqualTo(PlayMode.GOAL_LEFT);
        assertThat(game.score(TeamSide.LEFT)).isEqualTo(1);
        assertThat(game.score(TeamSide.RIGHT)).isZero();
        assertThat(game.match.events()).contains(new MatchEvent.GoalScored(TeamSide.LEFT, "Stars"));
    }

    @Test
    void fastBallThroughTheGoalCounts() {
        game.join("Stars", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);

        game.roll(14.5, 0, 60, 0);
        game.cycles(0.04);

        assertThat(game.playMode()).isEqualTo(PlayMode.GOAL_LEFT);
    }

    @Test
    void concedingTeamKicksOffThreeSecondsAfterGoal() {
        game.join("Stars", 1);
        game.join("Moons", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.roll(-14.8, 0, -4, 0);
        game.cycles(0.3);
        PlayMode afterGoal = game.playMode();

        game.cycles(3);

        assertThat(afterGoal).isEqualTo(PlayMode.GOAL_RIGHT);
        assertThat(game.playMode()).isEqualTo(PlayMode.KICK_OFF_LEFT);
        assertThat(game.world.ball().position().length()).isCloseTo(0.042, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({
        "  4.0,  9.9,  0,  3, KICK_IN_RIGHT,      4.0,    9.958",
        " 14.9,  5.0,  3,  0, GOAL_KICK_RIGHT,   14.0,    0.0",
        "-14.9, -5.0, -3,  0, CORNER_KICK_RIGHT, -14.958, -5.483"
    })
    void ballThatLeavesThePitchIsPlacedForTheOtherTeam(
            double x, double y, double speedX, double speedY, PlayMode kick, double kickX, double kickY) {
        Player player = game.join("Stars", 1);
        game.join("Moons", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.touch(player);

        game.roll(x, y, speedX, speedY);
        game.cycles(0.3);
        PlayMode out = game.playMode();
        game.cycles(1.2);

        assertThat(out).isEqualTo(kick);
        assertThat(game.ballDistance(kickX, kickY)).isLessThan(0.02);
    }

    @Test
    void playContinuesWhenABallThatWasNeverTouchedLeavesThePitch() {
        game.join("Stars", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);

        game.roll(4, 9.9, 0, 3);
        game.cycles(1);

        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void opponentsKeepAwayFromAKickIn() {
        game.join("Stars", 1);
        Player opponent = game.join("Moons", 1);
        game.roll(4, 9.8, 0, 0);
        game.cycle();
        game.match.setPlayMode(PlayMode.KICK_IN_LEFT);
        game.put(opponent, 4.5, 9);

        game.cycles(1.1);

        assertThat(Math.hypot(opponent.position().x() - 4, opponent.position().y() - 9.958))
                .isGreaterThan(2.3);
    }

    @ParameterizedTest
    @EnumSource(names = {"KICK_IN_LEFT", "CORNER_KICK_LEFT", "CORNER_KICK_RIGHT", "FREE_KICK_LEFT", "GOAL_KICK_RIGHT"})
    void ballThatNoRobotHasTouchedIsNotPlacedForAKick(PlayMode kick) {
        game.join("Stars", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.roll(20, 9.96, 0, 0);
        game.cycle();

        game.match.setPlayMode(kick);
        game.cycles(3);

        assertThat(game.playMode()).isEqualTo(kick);
        assertThat(game.ballDistance(20, 9.96)).isLessThan(0.01);
    }

    @Test
    void goalKickThatStaysInThePenaltyAreaBecomesDropBall() {
        Player player = game.join("Stars", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.touchAndLeave(player);
        game.match.setPlayMode(PlayMode.GOAL_KICK_LEFT);
        game.cycles(1.2);
        game.touch(player);

        game.cycles(15);

        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
        assertThat(game.ballDistance(-13.2, 3)).isLessThan(0.1);
    }

    @Test
    void goalKickIsOverWhenTheBallHasLeftThePenaltyArea() {
        Player player = game.join("Stars", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.touchAndLeave(player);
        game.match.setPlayMode(PlayMode.GOAL_KICK_LEFT);
        game.cycles(1.2);
        game.touch(player);
        PlayMode inside = game.playMode();

        game.roll(-13, 0, 0, 0);
        game.cycle();

        assertThat(inside).isEqualTo(PlayMode.GOAL_KICK_LEFT);
        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void freeKickInsidePenaltyAreaIsTakenFromItsCorner() {
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.touchAndLeave(game.join("Stars", 1));
        game.roll(14.5, 1, 0, 0);
        game.cycle();

        game.match.setPlayMode(PlayMode.FREE_KICK_LEFT);
        game.cycles(1.1);

        assertThat(game.ballDistance(13.2, 3)).isLessThan(0.02);
    }

    @Test
    void secondHalfBeginsAfterHalfTimeAndGameEndsAfterBoth() {
        Game shortGame = new Game(SoccerParameters.league().with("RuleHalfTime=2"));
        shortGame.join("Stars", 1);
        shortGame.match.kickOff();

        shortGame.cycles(2);
        PlayMode halfTime = shortGame.playMode();
        int half = shortGame.match.state().half();
        shortGame.match.kickOff();
        PlayMode secondKickOff = shortGame.playMode();
        shortGame.cycles(2);

        assertThat(halfTime).isEqualTo(PlayMode.BEFORE_KICK_OFF);
        assertThat(half).isEqualTo(2);
        assertThat(secondKickOff).isEqualTo(PlayMode.KICK_OFF_RIGHT);
        assertThat(shortGame.playMode()).isEqualTo(PlayMode.GAME_OVER);
        assertThat(shortGame.match.state().playSeconds()).isCloseTo(4, within(0.001));
    }

    @Test
    void teamsChangeSidesIfWanted() {
        Game changing =
                new Game(SoccerParameters.league().with("RuleHalfTime=2").with("ChangeSidesInSecondHalf=true"));
        Player player = changing.join("Stars", 1);
        changing.match.kickOff();

        changing.cycles(2);

        assertThat(player.side()).isEqualTo(TeamSide.RIGHT);
        assertThat(changing.match.teams().name(TeamSide.RIGHT)).isEqualTo("Stars");
    }

    @Test
    void kickerMayNotScoreStraightFromKickOff() {
        kickOffBetweenTwoTeams();

        game.roll(14.8, 0, 4, 0);
        game.cycles(0.3);

        assertThat(game.playMode()).isEqualTo(PlayMode.GOAL_KICK_RIGHT);
        assertThat(game.score(TeamSide.LEFT)).isZero();
    }

    @Test
    void goalCountsOnceAnOpponentHasTouchedTheBallAfterKickOff() {
        kickOffBetweenTwoTeams();
        game.touchAndLeave(game.match.players(TeamSide.RIGHT).get(0));

        game.roll(14.8, 0, 4, 0);
        game.cycles(0.3);

        assertThat(game.playMode()).isEqualTo(PlayMode.GOAL_LEFT);
    }

    @Test
    void secondTouchOfTheKickerGivesAFreeKick() {
        Player player = kickOffBetweenTwoTeams();
        game.cycles(0.5);

        game.touch(player);

        assertThat(game.playMode()).isEqualTo(PlayMode.FREE_KICK_RIGHT);
    }

    @Test
    void lonelyRobotMayDribbleFromKickOff() {
        Player player = game.join("Stars", 1);
        game.match.kickOff(TeamSide.LEFT);
        game.touchAndLeave(player);
        game.cycles(0.5);

        game.touch(player);

        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void dropBallMakesRoom() {
        Player player = game.join("Stars", 1);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        game.put(player, -1, 0);

        game.match.dropBall();
        game.cycle();

        assertThat(player.position().x()).isCloseTo(-2.5, within(0.05));
    }

    /** Lets a robot of the left team kick off; returns the robot. */
    private Player kickOffBetweenTwoTeams() {
        Player player = game.join("Stars", 1);
        game.join("Stars", 2);
        game.join("Moons", 1);
        game.match.kickOff(TeamSide.LEFT);
        game.touchAndLeave(player);
        return player;
    }
}
