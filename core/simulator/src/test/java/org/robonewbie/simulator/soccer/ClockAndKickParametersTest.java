package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

/** Each parameter of clock, kick-off and kicks changes the game as it says. */
class ClockAndKickParametersTest {

    @Test
    void coinDecidesTheFirstKickOffIfWanted() {
        boolean leftSeen = false;
        boolean rightSeen = false;
        for (int seed = 0; seed < 20; seed++) {
            Game game = new Game(SoccerParameters.league().with("CoinTossForKickOff=true"), seed * 7_919_000_001L);
            game.match.kickOff();
            leftSeen |= game.playMode() == PlayMode.KICK_OFF_LEFT;
            rightSeen |= game.playMode() == PlayMode.KICK_OFF_RIGHT;
        }

        assertThat(leftSeen && rightSeen).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"AutomaticKickOff=true, 30", "WaitBeforeKickOff=2, 2"})
    void automaticKickOffComesAfterItsTime(String assignment, double seconds) {
        Game game = game("AutomaticKickOff=true", assignment);
        game.join("Stars", 1);

        game.cycles(seconds - 0.1);
        PlayMode before = game.playMode();
        game.cycles(0.3);

        assertThat(before).isEqualTo(PlayMode.BEFORE_KICK_OFF);
        assertThat(game.playMode()).isEqualTo(PlayMode.KICK_OFF_LEFT);
    }

    @Test
    void automaticKickOffWaitsForARobot() {
        Game game = game("AutomaticKickOff=true", "WaitBeforeKickOff=1");

        game.cycles(5);

        assertThat(game.playMode()).isEqualTo(PlayMode.BEFORE_KICK_OFF);
    }

    @Test
    void robotsMayStandAnywhereIfWanted() {
        Game game = game("StartAnyFieldPosition=true");
        Player player = game.join("Stars", 1);
        game.put(player, 3, 1);

        game.cycle();
        game.match.kickOff(TeamSide.RIGHT);
        game.cycle();

        assertThat(player.position().x()).isCloseTo(3, within(0.05));
    }

    @Test
    void oneHalfIsEnoughIfWanted() {
        Game game = game("SingleHalfTime=true", "RuleHalfTime=2");
        game.join("Stars", 1);
        game.match.kickOff();

        game.cycles(2.1);

        assertThat(game.playMode()).isEqualTo(PlayMode.GAME_OVER);
    }

    @Test
    void programEndsTenSecondsAfterTheGameIfWanted() {
        Game quitting = game("SingleHalfTime=true", "RuleHalfTime=1", "AutomaticQuit=true");
        Game staying = game("SingleHalfTime=true", "RuleHalfTime=1");
        quitting.match.kickOff();
        staying.match.kickOff();

        quitting.cycles(10.9);
        boolean before = quitting.match.isProgramOver();
        quitting.cycles(0.3);
        staying.cycles(12);

        assertThat(before).isFalse();
        assertThat(quitting.match.isProgramOver()).isTrue();
        assertThat(staying.match.isProgramOver()).isFalse();
    }

    @Test
    void pauseAfterAGoalCanBeSet() {
        Game game = playing("RuleGoalPauseTime=1");
        game.roll(14.8, 0, 4, 0);
        game.cycles(0.3);
        PlayMode goal = game.playMode();

        game.cycles(1);

        assertThat(goal).isEqualTo(PlayMode.GOAL_LEFT);
        assertThat(game.playMode()).isEqualTo(PlayMode.KICK_OFF_RIGHT);
        assertThat(game.ballDistance(0, 0)).isLessThan(0.01);
    }

    @Test
    void ballRollsOnDuringThePauseBeforeAKickWhichCanBeSet() {
        Game game = playing("RuleKickInPauseTime=2");
        game.touchAndLeave(game.join("Stars", 1));
        game.roll(4, 9.8, 0, 0);
        game.cycle();
        game.match.setPlayMode(PlayMode.KICK_IN_LEFT);
        game.roll(0, 0, 0, 0);

        game.cycles(1.9);
        double before = game.ballDistance(0, 0);
        game.cycles(0.2);

        assertThat(before).isLessThan(0.01);
        assertThat(game.ballDistance(4, 9.958)).isLessThan(0.01);
    }

    @ParameterizedTest
    @CsvSource({
        "KICK_OFF_LEFT, FreeKickRules=true, 15",
        "CORNER_KICK_LEFT, FreeKickRules=true, 15",
        "FREE_KICK_LEFT, RuleDropBallTime=3, 3"
    })
    void kickThatIsNotTakenBecomesADropBall(PlayMode kick, String assignment, double seconds) {
        Game game = playing(assignment);
        game.join("Stars", 1);
        game.match.setPlayMode(kick);

        game.cycles(seconds - 0.1);
        PlayMode before = game.playMode();
        game.cycles(0.2);

        assertThat(before).isEqualTo(kick);
        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void placeOfTheGoalKickCanBeSet() {
        Game game = playing("GoalKickDist=2.5");
        game.touchAndLeave(game.join("Stars", 1));
        game.match.setPlayMode(PlayMode.GOAL_KICK_LEFT);

        game.cycles(1.1);

        assertThat(game.ballDistance(-12.5, 0)).isLessThan(0.01);
    }

    @Test
    void roomAroundAKickCanBeSet() {
        Game game = playing("FreeKickDistance=3", "FreeKickMoveDist=4");
        game.put(game.join("Stars", 11), -8, 8);
        Player opponent = game.join("Moons", 2);
        game.put(opponent, 2.6, 0);
        game.match.setPlayMode(PlayMode.FREE_KICK_LEFT);

        game.cycles(1.1);

        assertThat(opponent.position().x()).isCloseTo(4, within(0.1));
    }

    @Test
    void kickingTeamIsPushedFromTheBallOnce() {
        Game game = playing("KickRepelDist=0.8");
        Player kicker = game.join("Stars", 2);
        game.touchAndLeave(kicker);
        game.roll(0, 0, 0, 0);
        game.cycle();
        game.put(kicker, -0.3, 0);
        game.match.setPlayMode(PlayMode.FREE_KICK_LEFT);

        game.cycles(1.04);

        assertThat(kicker.position().x()).isCloseTo(-0.8, within(0.05));
    }

    @Test
    void opponentsLeaveThePenaltyAreaAtAGoalKick() {
        Game game = playing();
        game.put(game.join("Stars", 11), -8, 8);
        Player opponent = game.join("Moons", 2);
        game.put(opponent, -14, 1.5);
        game.match.setPlayMode(PlayMode.GOAL_KICK_LEFT);

        game.cycles(1.1);

        assertThat(opponent.position().x()).isCloseTo(-13.2 + 2.5, within(0.1));
    }

    @Test
    void sizeOfThePenaltyAreaCanBeSet() {
        Game game = playing("PenaltyLength=4", "PenaltyWidth=6");
        game.touchAndLeave(game.join("Stars", 1));
        game.roll(12, 3, 0, 0);
        game.cycle();
        game.match.setPlayMode(PlayMode.FREE_KICK_LEFT);

        game.cycles(1.1);

        assertThat(game.ballDistance(11, 4.05)).isLessThan(0.01);
    }

    @ParameterizedTest
    @EnumSource(names = {"KICK_IN_LEFT", "CORNER_KICK_LEFT", "FREE_KICK_LEFT", "DIRECT_FREE_KICK_LEFT"})
    void firstTouchEndsAKick(PlayMode kick) {
        Game game = playing();
        Player kicker = game.join("Stars", 2);
        game.match.setPlayMode(kick);
        game.cycles(1.2);

        game.touch(kicker);

        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void trainersKickOffLeavesTheBallWhereItIs() {
        Game game = playing();
        game.roll(3, 2, 0, 0);

        game.match.kickOff(TeamSide.LEFT);
        game.cycle();

        assertThat(game.ballDistance(3, 2)).isLessThan(0.01);
    }

    @ParameterizedTest
    @CsvSource({
        "DIRECT_FREE_KICK_LEFT, FreeKickRules=true,   14.8, GOAL_LEFT",
        "CORNER_KICK_LEFT,      FreeKickRules=true,   14.8, GOAL_LEFT",
        "FREE_KICK_LEFT,        FreeKickRules=true,   14.8, GOAL_KICK_RIGHT",
        "KICK_IN_LEFT,          FreeKickRules=true,   14.8, GOAL_KICK_RIGHT",
        "FREE_KICK_LEFT,        FreeKickRules=false,  14.8, GOAL_LEFT",
        "DIRECT_FREE_KICK_LEFT, FreeKickRules=true,  -14.8, CORNER_KICK_RIGHT"
    })
    void shotFromAKickCountsOnlyIfItIsDirect(PlayMode kick, String assignment, double x, PlayMode after) {
        Game game = threePlayers(assignment);
        game.match.setPlayMode(kick);
        game.cycles(1.2);
        game.touchAndLeave(game.match.players(TeamSide.LEFT).get(0));

        game.roll(x, 0, Math.signum(x) * 4, 0);
        game.cycles(0.3);

        assertThat(game.playMode()).isEqualTo(after);
    }

    @Test
    void ballAndGoalHaveTheSizesThatWereSet() {
        Game wide = playing("GoalWidth=4", "GoalHeight=2", "GoalDepth=1", "BallRadius=0.1", "BallMass=0.5");

        wide.roll(14.8, 1.7, 4, 0);
        wide.cycles(0.3);

        assertThat(wide.world.ball().properties().radius()).isEqualTo(0.1);
        assertThat(wide.world.ball().properties().massKg()).isEqualTo(0.5);
        assertThat(wide.playMode()).isEqualTo(PlayMode.GOAL_LEFT);
    }

    @Test
    void pitchHasTheSizeThatWasSet() {
        Game game = playing("FieldLength=10", "FieldWidth=6");
        Player player = game.join("Stars", 2);
        game.touchAndLeave(player);

        game.roll(0, 2.9, 0, 3);
        game.cycles(0.3);

        assertThat(game.playMode()).isEqualTo(PlayMode.KICK_IN_RIGHT);
    }

    @Test
    void widthOfTheRoomOfARobotCanBeSet() {
        Game game = game("AgentRadius=0.6");

        Player player = game.join("Stars", 1);

        assertThat(player.position().distanceTo(new Vector3(-15 + 1.2, 10 - 1.2, 0.6)))
                .isLessThan(1e-9);
    }

    private static Game threePlayers(String... assignments) {
        Game game = playing(assignments);
        game.join("Stars", 2);
        game.put(game.join("Stars", 3), -8, 3);
        game.put(game.join("Moons", 2), 8, -3);
        return game;
    }

    private static Game game(String... assignments) {
        return new Game(SoccerParameters.league(), assignments);
    }

    private static Game playing(String... assignments) {
        Game game = game(assignments);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        return game;
    }
}
