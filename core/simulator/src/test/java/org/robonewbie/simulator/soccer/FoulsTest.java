package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.FoulType;

class FoulsTest {

    private final Game game = playing(SoccerParameters.league());

    @Test
    void robotThatLiesTooLongIsLiftedAndPutBesideThePitch() {
        Game quick = playing(SoccerParameters.league().with("GroundMaxTime=2"));
        Player player = quick.lying(5);

        quick.cycles(2.2);
        double lifted = player.position().z();
        quick.cycles(0.6);

        assertThat(lifted).isGreaterThan(0.9);
        assertThat(player.position().x()).isCloseTo(-1.2, within(0.05));
        assertThat(player.position().y()).isCloseTo(-10.5, within(0.05));
        assertThat(quick.match.fouls()).hasSize(26).allMatch(foul -> foul.type() == FoulType.INCAPABLE);
        assertThat(quick.match.events()).contains(new MatchEvent.FoulCalled(FoulType.INCAPABLE, TeamSide.LEFT, 5));
    }

    @Test
    void goalkeeperMayLieTwiceAsLong() {
        Game quick = playing(SoccerParameters.league().with("GroundMaxTime=1"));
        quick.lying(1);

        quick.cycles(5);

        assertThat(quick.match.fouls()).isEmpty();
    }

    @Test
    void lyingIsNotJudgedBeforeKickOff() {
        Game quick = playing(SoccerParameters.league().with("GroundMaxTime=2"));
        quick.lying(5);
        quick.match.setPlayMode(PlayMode.BEFORE_KICK_OFF);

        quick.cycles(3);

        assertThat(quick.match.fouls()).isEmpty();
    }

    @Test
    void fourthRobotInOwnPenaltyAreaIsMovedOut() {
        for (int i = 1; i <= 3; i++) {
            game.put(game.join("Stars", i), -14, -2.0 + i);
        }
        Player last = game.join("Stars", 4);
        game.put(last, -10, 0);
        game.cycle();
        game.put(last, -13.5, 2);

        game.cycle();

        assertThat(last.position().x()).isGreaterThan(-13.2);
        assertThat(types()).containsExactly(FoulType.ILLEGAL_DEFENCE);
    }

    @Test
    void robotThatJoinsTwoTouchingRobotsIsMovedAway() {
        Player first = game.join("Stars", 2);
        Player second = game.join("Moons", 2);
        Player third = game.join("Stars", 3);
        game.put(third, -8, 5);
        touchEachOther(first, second);
        game.cycle();
        List<FoulType> two = types();

        game.put(third, first.position().x(), first.position().y() + 0.2);
        game.cycle();

        assertThat(two).isEmpty();
        assertThat(types()).containsExactly(FoulType.TOUCHING);
        assertThat(third.position().distanceTo(first.position())).isGreaterThan(0.4);
    }

    @Test
    void robotThatRunsIntoAnOpponentFarFromTheBallLeavesThePitch() {
        Player runner = game.join("Stars", 2);
        Player victim = game.join("Moons", 2);
        game.put(victim, -5, 5);
        game.put(runner, -5.35, 5);
        game.cycles(1.5);

        push(runner, 120);

        assertThat(types()).isNotEmpty().allMatch(type -> type == FoulType.CHARGING);
        assertThat(game.match.fouls().get(0).player().side()).isEqualTo(TeamSide.LEFT);
    }

    @Test
    void chargingCanBeSwitchedOff() {
        Game beginners = playing(SoccerParameters.beginner());
        Player runner = beginners.join("Stars", 2);
        Player victim = beginners.join("Moons", 2);
        beginners.put(victim, -3, 2);
        beginners.put(runner, -3.35, 2);
        beginners.cycles(1.5);

        push(beginners, runner, 120);

        assertThat(beginners.match.fouls()).isEmpty();
    }

    @Test
    void crowdingIsJudgedWithTheOldDistances() {
        Game old = playing(SoccerParameters.league()
                .with("MinOppDistance=0.8")
                .with("Min2PlDistance=0.4")
                .with("Min3PlDistance=1.0"));
        old.put(old.join("Stars", 2), -0.3, 0.25);
        Player second = old.join("Stars", 3);
        old.put(second, -0.2, -0.3);
        old.put(old.join("Moons", 2), 0.5, 0);

        old.cycle();

        assertThat(old.match.fouls()).isNotEmpty();
        assertThat(old.match.fouls().get(0).type()).isEqualTo(FoulType.CROWDING);
        assertThat(old.match.fouls().get(0).player().number()).isEqualTo(2);
    }

    @Test
    void armThatRunsIntoTheBodyIsFrozenForASecond() {
        Player player = game.hittingItself();
        int hinge = player.robot().nao().hingeIndex(Joint.RIGHT_SHOULDER_PITCH);

        boolean frozen = game.match.isFrozen(player, hinge);
        game.cycles(1.1);

        assertThat(types()).contains(FoulType.SELF_COLLISION);
        assertThat(frozen).isTrue();
        assertThat(game.match.isFrozen(player, hinge)).isFalse();
    }

    @Test
    void standingRobotDoesNotHitItself() {
        Player player = game.join("Stars", 2);
        game.put(player, -5, 2);

        game.cycles(2);

        assertThat(types()).isEmpty();
    }

    @Test
    void passModeIsGrantedAtTheBallAndLocksTheGoal() {
        Player passer = game.join("Stars", 2);
        game.join("Moons", 2);
        game.put(passer, -0.4, 0);
        game.cycles(3.1);

        game.match.requestPass(passer);
        PlayMode granted = game.playMode();
        game.cycles(4.1);
        PlayMode after = game.playMode();
        double wait = game.match.scoreWaitSeconds(TeamSide.LEFT);
        game.roll(14.8, 0, 4, 0);
        game.cycles(0.3);

        assertThat(granted).isEqualTo(PlayMode.PASS_LEFT);
        assertThat(after).isEqualTo(PlayMode.PLAY_ON);
        assertThat(wait).isBetween(9.0, 10.0);
        assertThat(game.playMode()).isEqualTo(PlayMode.GOAL_KICK_RIGHT);
    }

    @Test
    void passModeIsRefusedFarFromTheBall() {
        Player passer = game.join("Stars", 2);
        game.put(passer, -2, 0);
        game.cycles(3.1);

        game.match.requestPass(passer);

        assertThat(game.playMode()).isEqualTo(PlayMode.PLAY_ON);
    }

    @Test
    void keepawayEndsWhenTheBallLeavesItsArea() {
        Game keepaway = playing(SoccerParameters.league().with("Keepaway=true"));
        keepaway.join("Stars", 2);
        keepaway.cycle();
        PlayMode inside = keepaway.playMode();

        keepaway.roll(10.5, 0, 0, 0);
        keepaway.cycle();

        assertThat(inside).isEqualTo(PlayMode.PLAY_ON);
        assertThat(keepaway.playMode()).isEqualTo(PlayMode.GAME_OVER);
    }

    @Test
    void goalkeeperThatLeavesItsAreaInAShootoutConcedes() {
        Game shootout = playing(SoccerParameters.league().with("PenaltyShootout=true"));
        shootout.join("Stars", 2);
        Player keeper = shootout.join("Moons", 1);
        shootout.put(keeper, 14, 0);
        shootout.cycle();
        PlayMode inside = shootout.playMode();

        shootout.put(keeper, 12, 0);
        shootout.cycle();

        assertThat(inside).isEqualTo(PlayMode.PLAY_ON);
        assertThat(shootout.playMode()).isEqualTo(PlayMode.GOAL_LEFT);
    }

    private static Game playing(SoccerParameters parameters) {
        Game game = new Game(parameters);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        return game;
    }

    private List<FoulType> types() {
        return game.match.fouls().stream().map(Foul::type).toList();
    }

    private void touchEachOther(Player first, Player second) {
        game.put(first, -5, 0);
        game.put(second, -5, 0.2);
    }

    private void push(Player player, double newtons) {
        push(game, player, newtons);
    }

    /** Pushes a robot along x for half a second. */
    private static void push(Game game, Player player, double newtons) {
        for (int i = 0; i < 25; i++) {
            player.robot().push(new Vector3(newtons, 0, 0));
            game.cycle();
        }
    }
}
