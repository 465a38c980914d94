package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.protocol.order.PlayerNumber;

/** Each parameter of the automatic referee changes its judgement as it says. */
class FoulParametersTest {

    @ParameterizedTest
    @CsvSource({
        "GroundMaxTime=1, 5",
        "GoalieGroundMaxTime=1, 1",
        "NotStandingMaxTime=1, 5",
        "GoalieNotStandingMaxTime=1, 1"
    })
    void timeThatARobotMayLieCanBeSet(String assignment, int number) {
        Game game = playing(assignment);
        Player player = game.lying(number);

        game.cycles(0.9);
        Set<FoulType> before = types(game);
        game.cycles(0.3);

        assertThat(before).isEmpty();
        assertThat(types(game)).containsExactly(FoulType.INCAPABLE);
        assertThat(player.number()).isEqualTo(number);
    }

    @Test
    void punishedRobotIsPutAsideAtOnceIfWanted() {
        Game game = playing("GroundMaxTime=1", "FoulHoldTime=0");
        Player player = game.lying(5);

        game.cycles(1.2);

        assertThat(Math.abs(player.position().y())).isGreaterThan(10);
        assertThat(game.match.fouls()).hasSize(1);
    }

    @Test
    void numberOfDefendersCanBeSet() {
        Game game = playing("MaxPlayersInsideOwnArea=1");
        game.put(game.join("Stars", 2), -14, -1);
        game.cycle();
        Player last = game.join("Stars", 3);
        game.put(last, -13.5, 2);

        game.cycle();

        assertThat(types(game)).containsExactly(FoulType.ILLEGAL_DEFENCE);
        assertThat(last.position().x()).isGreaterThan(-13.2);
    }

    @Test
    void illegalDefenceCanPutARobotOffThePitch() {
        Game game = playing("MaxPlayersInsideOwnArea=0", "IllegalDefenseBeamPenalty=true");
        Player player = game.join("Stars", 3);
        game.put(player, -13.5, 2);

        game.cycles(0.7);

        assertThat(Math.abs(player.position().y())).isGreaterThan(10);
    }

    @Test
    void sizeOfATouchingGroupCanBeSet() {
        Game game = playing("MaxTouchGroupSize=3");
        threeTouching(game);

        assertThat(types(game)).isEmpty();
    }

    @Test
    void touchingCanPutARobotOffThePitch() {
        Game game = playing("TouchingFoulBeamPenalty=true");
        Player third = threeTouching(game);

        game.cycles(0.7);

        assertThat(types(game)).contains(FoulType.TOUCHING);
        assertThat(Math.abs(third.position().y())).isGreaterThan(10);
    }

    @Test
    void goalkeeperThatJoinsAGroupIsSparedForATeamMate() {
        Game game = playing();
        Player mate = game.join("Stars", 2);
        Player keeper = game.join("Stars", 1);
        Player opponent = game.join("Moons", 2);
        game.put(keeper, -8, 5);
        game.put(mate, -5, 0);
        game.put(opponent, -5, 0.2);
        game.cycle();

        game.put(keeper, mate.position().x(), mate.position().y() + 0.2);
        game.cycle();

        assertThat(game.match.fouls())
                .filteredOn(foul -> foul.type() == FoulType.TOUCHING)
                .extracting(Foul::player)
                .containsExactly(new PlayerNumber(TeamSide.LEFT, 2));
    }

    @ParameterizedTest
    @CsvSource({"0.8, true", "0.2, false"})
    void crowdingDependsOnTheDistanceOfTheOpponent(double distance, boolean foul) {
        Game game = crowd("MinOppDistance=" + distance, "Min2PlDistance=0.5");

        assertThat(types(game).contains(FoulType.CROWDING)).isEqualTo(foul);
    }

    @ParameterizedTest
    @CsvSource({
        "Min2PlDistance=0.6, true",
        "Min2PlDistance=0.3, false",
        "Min3PlDistance=1.2, true",
        "Min3PlDistance=0.7, false"
    })
    void crowdingDependsOnTheDistancesOfTheTeam(String assignment, boolean foul) {
        Game game = crowd("MinOppDistance=0.8", assignment);

        assertThat(types(game).contains(FoulType.CROWDING)).isEqualTo(foul);
    }

    @Test
    void selfCollisionsAreNoFoulIfWanted() {
        Game game = playing("FoulOnSelfCollisions=false");
        game.hittingItself();

        assertThat(types(game)).isEmpty();
    }

    @Test
    void deepOverlapCanBeTolerated() {
        Game game = playing("SelfCollisionsTolerance=1");
        game.hittingItself();

        assertThat(types(game)).isEmpty();
    }

    @Test
    void timeThatJointsAreFrozenCanBeSet() {
        Game game = playing("SelfCollisionJointFrozenTime=0.4", "SelfCollisionJointThawTime=1000");
        Player player = game.hittingItself();
        int hinge = player.robot().nao().hingeIndex(Joint.RIGHT_SHOULDER_PITCH);

        boolean frozen = game.match.isFrozen(player, hinge);
        game.cycles(0.45);

        assertThat(frozen).isTrue();
        assertThat(game.match.isFrozen(player, hinge)).isFalse();
        assertThat(game.match.fouls()).hasSize(1);
    }

    @Test
    void jointsFreezeAgainAfterTheirTimeOfGrace() {
        Game game = playing("SelfCollisionJointFrozenTime=0.1", "SelfCollisionJointThawTime=0.1");
        Player player = game.hittingItself();

        for (int i = 0; i < 100; i++) {
            Game.turn(player, Joint.RIGHT_SHOULDER_PITCH, 0);
            Game.turn(player, Joint.RIGHT_ARM_ROLL, 0);
            Game.turn(player, Joint.RIGHT_ARM_YAW, 0);
            game.cycle();
        }
        for (int i = 0; i < 100; i++) {
            Game.bendArm(player);
            game.cycle();
        }

        assertThat(game.match.fouls()).hasSizeGreaterThan(1);
    }

    @Test
    void selfCollisionCanPutARobotOffThePitchNowAndThen() {
        Game game = playing("SelfCollisionBeamPenalty=true", "SelfCollisionBeamCooldownTime=1000");
        Player player = game.hittingItself();

        game.cycles(0.7);

        assertThat(Math.abs(player.position().y())).isGreaterThan(10);
        game.cycles(3);
        assertThat(game.match.fouls()).hasSize(26);
    }

    @Test
    void safePlaceIsNotSearchedIfNotWanted() {
        assertThat(placeBesideAnother("MaxNumSafeRepositionAttempts=0")).isLessThan(0.05);
        assertThat(placeBesideAnother("MaxNumSafeRepositionAttempts=100")).isGreaterThan(0.4);
    }

    private static Game playing(String... assignments) {
        Game game = new Game(SoccerParameters.league(), assignments);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        return game;
    }

    private static Set<FoulType> types(Game game) {
        return game.match.fouls().stream().map(Foul::type).collect(Collectors.toSet());
    }

    private static Player threeTouching(Game game) {
        Player first = game.join("Stars", 2);
        Player second = game.join("Moons", 2);
        Player third = game.join("Stars", 3);
        game.put(third, -8, 5);
        game.put(first, -5, 0);
        game.put(second, -5, 0.2);
        game.cycle();
        game.put(third, first.position().x(), first.position().y() + 0.2);
        game.cycle();
        return third;
    }

    /** Puts three of a team and an opponent around the ball: at 0.25 and 0.4, 0.9, and 0.5 metres. */
    private static Game crowd(String... assignments) {
        Game game = playing(assignments);
        game.put(game.join("Stars", 2), -0.25, 0);
        game.put(game.join("Stars", 3), 0, -0.4);
        game.put(game.join("Stars", 4), 0, 0.9);
        game.put(game.join("Moons", 2), 0.5, 0);
        game.cycle();
        return game;
    }

    /** Returns the distance in metres between a robot and another one that is moved to the same place. */
    private static double placeBesideAnother(String assignment) {
        Game game = playing(assignment);
        List<Player> players = List.of(game.join("Stars", 2), game.join("Stars", 3));
        game.put(players.get(0), -2.5, 0);
        game.put(players.get(1), -1, 0);
        game.match.dropBall();
        return players.get(1).position().distanceTo(players.get(0).position());
    }
}
