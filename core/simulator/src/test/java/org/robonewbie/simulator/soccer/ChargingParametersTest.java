package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.FoulType;

/** Each parameter of the rule against running into opponents changes its judgement as it says. */
class ChargingParametersTest {

    @ParameterizedTest
    @CsvSource({
        "UseCharging=true, true",
        "UseCharging=false, false",
        "ChargingMinSpeed=5, false",
        "ChargingMinCollisionSpeed=5, false",
        "ChargingMinCollBallDist=50, false",
        "Keepaway=true, true"
    })
    void chargingFarFromTheBallDependsOnSpeedAndPlace(String assignment, boolean foul) {
        Game game = playing(assignment, "KeepawayLength=100", "KeepawayWidth=100");

        charge(game, "Stars", "Moons");

        assertThat(types(game).contains(FoulType.CHARGING)).isEqualTo(foul);
    }

    @Test
    void rightTeamMayChargeInKeepaway() {
        Game game = playing("Keepaway=true", "KeepawayLength=100", "KeepawayWidth=100");
        game.put(game.join("Stars", 9), -10, -8);

        charge(game, "Moons", "Stars");

        assertThat(types(game)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "ChargingMinBallSpeedAngle=30, true",
        "ChargingMinBallSpeedAngle=120, false",
        "ChargingMinBallSpeedAngle=120 ChargingMaxBallRulesDist=0.1, true"
    })
    void whoGoesPastTheBallChargesUnlessItsWayIsNearEnough(String assignments, boolean foul) {
        Game game = playing(assignments.split(" ", -1));
        game.roll(-5.2, 5.6, 0, 0);

        charge(game, "Stars", "Moons");

        assertThat(types(game).contains(FoulType.CHARGING)).isEqualTo(foul);
    }

    @ParameterizedTest
    @CsvSource({"ChargingMinDeltaDist=0.05, true", "ChargingMinDeltaDist=5, false"})
    void whoIsFartherFromTheBallCharges(String assignment, boolean foul) {
        Game game = playing(assignment);
        game.roll(-4.55, 5, 0, 0);

        charge(game, "Stars", "Moons");

        assertThat(types(game).contains(FoulType.CHARGING)).isEqualTo(foul);
    }

    @Test
    void whoHasTouchedTheBallMayChargeForATime() {
        assertThat(chargeAfterTouch("ChargingImmunityTime=1000")).isEmpty();
        assertThat(chargeAfterTouch("ChargingImmunityTime=0")).containsExactly(FoulType.CHARGING);
    }

    /** The one behind catches up with the one in front; both go for the ball, but only one has its opponent before it. */
    @ParameterizedTest
    @CsvSource({"ChargingMinDeltaAng=15, true", "ChargingMinDeltaAng=190, false"})
    void whoIsFartherChargesOnlyIfTheDirectionsDiffer(String assignment, boolean foul) {
        Game game = playing(assignment, "ChargingMinSpeed=0.02");
        Player runner = game.join("Stars", 2);
        Player victim = game.join("Moons", 2);
        game.roll(-4.4, 5, 0, 0);
        game.put(victim, -5, 5);
        game.put(runner, -5.4, 5);
        game.cycles(1.5);

        for (int i = 0; i < 25; i++) {
            runner.robot().push(new Vector3(120, 0, 0));
            victim.robot().push(new Vector3(25, 0, 0));
            game.cycle();
        }

        assertThat(types(game).contains(FoulType.CHARGING)).isEqualTo(foul);
    }

    @ParameterizedTest
    @CsvSource({"ChargingCollisionMinTime=0.2, true", "ChargingCollisionMinTime=1000, false"})
    void whoCollidedShortlyBeforeIsNotJudgedAgain(String assignment, boolean foul) {
        Game game = playing(assignment);
        Player runner = game.join("Stars", 2);
        Player victim = game.join("Moons", 2);
        game.put(victim, -5, 5);
        game.put(runner, -5.2, 5);
        game.cycle();

        charge(game, runner, victim);

        assertThat(types(game).contains(FoulType.CHARGING)).isEqualTo(foul);
    }

    private static Game playing(String... assignments) {
        Game game = new Game(SoccerParameters.league(), assignments);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        return game;
    }

    private static Set<FoulType> types(Game game) {
        return game.match.fouls().stream().map(Foul::type).collect(Collectors.toSet());
    }

    /** Pushes a robot into an opponent that stands in its way. */
    private static void charge(Game game, String runners, String victims) {
        Player runner = game.join(runners, 2);
        Player victim = game.join(victims, 2);
        charge(game, runner, victim);
    }

    private static void charge(Game game, Player runner, Player victim) {
        game.put(victim, -5, 5);
        game.put(runner, -5.35, 5);
        game.cycles(1.5);
        for (int i = 0; i < 25; i++) {
            runner.robot().push(new Vector3(120, 0, 0));
            game.cycle();
        }
    }

    private static Set<FoulType> chargeAfterTouch(String assignment) {
        Game game = playing(assignment);
        Player runner = game.join("Stars", 2);
        Player victim = game.join("Moons", 2);
        game.put(victim, 9, 5);
        game.touch(runner);
        charge(game, runner, victim);
        return types(game);
    }
}
