package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.world.SoccerWorld;

class TeamsTest {

    private final SoccerWorld world = new SoccerWorld(SoccerParameters.league().field());
    private final Teams teams = new Teams(SoccerParameters.league());

    @Test
    void firstTeamIsLeftAndSecondIsRight() throws JoinRefusedException {
        Player first = join("Stars", 1);
        Player second = join("Moons", 1);

        assertThat(first.side()).isEqualTo(TeamSide.LEFT);
        assertThat(second.side()).isEqualTo(TeamSide.RIGHT);
    }

    @Test
    void thirdTeamIsRefused() throws JoinRefusedException {
        join("Stars", 1);
        join("Moons", 1);

        assertThatThrownBy(() -> join("Suns", 1))
                .isInstanceOf(JoinRefusedException.class)
                .hasMessage("teams \"Stars\" and \"Moons\" are already playing; there is no room for team \"Suns\"");
    }

    @Test
    void nameOfTeamStaysReservedWhenItsPlayersLeave() throws JoinRefusedException {
        teams.leave(join("Stars", 1));
        join("Moons", 1);

        assertThatThrownBy(() -> join("Suns", 1)).isInstanceOf(JoinRefusedException.class);
        assertThat(join("Stars", 1).side()).isEqualTo(TeamSide.LEFT);
    }

    @Test
    void nameOfTeamWithoutPlayersIsFreeAfterAReset() throws JoinRefusedException {
        teams.leave(join("Stars", 1));
        join("Moons", 1);

        teams.removeEmpty();

        assertThat(teams.name(TeamSide.LEFT)).isEmpty();
        assertThat(join("Suns", 1).side()).isEqualTo(TeamSide.LEFT);
        assertThat(join("Moons", 2).side()).isEqualTo(TeamSide.RIGHT);
    }

    @Test
    void takenNumberIsRefused() throws JoinRefusedException {
        join("Stars", 3);

        assertThatThrownBy(() -> join("Stars", 3))
                .hasMessage("number 3 of team \"Stars\" is taken; choose another one, or 0 for any free one");
    }

    @Test
    void numberZeroTakesLowestFreeNumber() throws JoinRefusedException {
        join("Stars", 1);
        join("Stars", 3);

        assertThat(join("Stars", 0).number()).isEqualTo(2);
    }

    @Test
    void numberTwelveIsRefused() {
        assertThatThrownBy(() -> join("Stars", 12)).hasMessage("number 12 does not exist; choose 1 to 11");
    }

    @Test
    void twelfthPlayerIsRefused() throws JoinRefusedException {
        Teams beginners = new Teams(SoccerParameters.beginner());
        for (int i = 1; i <= 11; i++) {
            beginners.join("Stars", i, world.addRobot(RobotType.TYPE_0));
        }

        assertThatThrownBy(() -> beginners.join("Stars", 0, world.addRobot(RobotType.TYPE_0)))
                .hasMessage("team \"Stars\" already has all 11 players");
    }

    @Test
    void leagueAllowsSevenRobotsOfOneType() throws JoinRefusedException {
        for (int i = 1; i <= 7; i++) {
            join("Stars", i);
        }

        assertThatThrownBy(() -> join("Stars", 8)).hasMessageContaining("MaxRobotTypeCount is 7");
    }

    @Test
    void leagueAllowsNineRobotsOfTwoTypes() throws JoinRefusedException {
        for (int i = 1; i <= 7; i++) {
            join("Stars", i);
        }
        teams.join("Stars", 8, world.addRobot(RobotType.TYPE_1));
        teams.join("Stars", 9, world.addRobot(RobotType.TYPE_1));

        assertThatThrownBy(() -> teams.join("Stars", 10, world.addRobot(RobotType.TYPE_1)))
                .hasMessageContaining("MaxSumTwoRobotTypes");
        assertThat(teams.join("Stars", 10, world.addRobot(RobotType.TYPE_2)).number())
                .isEqualTo(10);
    }

    @Test
    void fullTeamNeedsThreeTypes() throws JoinRefusedException {
        Teams onlyVariety =
                new Teams(SoccerParameters.league().with("MaxRobotTypeCount=11").with("MaxSumTwoRobotTypes=11"));
        for (int i = 1; i <= 9; i++) {
            onlyVariety.join("Stars", i, world.addRobot(RobotType.TYPE_0));
        }

        assertThatThrownBy(() -> onlyVariety.join("Stars", 10, world.addRobot(RobotType.TYPE_0)))
                .hasMessageContaining("needs 2 more types");
        assertThat(onlyVariety
                        .join("Stars", 10, world.addRobot(RobotType.TYPE_1))
                        .number())
                .isEqualTo(10);
    }

    @Test
    void aFullTeamMayBeOfOneTypeIfWanted() throws JoinRefusedException {
        Teams equal = new Teams(SoccerParameters.league()
                .with("MaxRobotTypeCount=11")
                .with("MaxSumTwoRobotTypes=11")
                .with("MinRobotTypesCount=1"));

        for (int i = 1; i <= 11; i++) {
            equal.join("Stars", i, world.addRobot(RobotType.TYPE_0));
        }

        assertThat(equal.player(TeamSide.LEFT, 11)).isPresent();
    }

    @Test
    void robotsAppearAtTheSideLineOfTheirHalf() throws JoinRefusedException {
        Player first = join("Stars", 1);
        Player second = join("Stars", 2);
        Player opponent = join("Moons", 1);

        assertThat(first.position().x()).isCloseTo(-14.2, within(1e-9));
        assertThat(first.position().y()).isCloseTo(9.2, within(1e-9));
        assertThat(second.position().y()).isCloseTo(8.0, within(1e-9));
        assertThat(opponent.position().x()).isCloseTo(14.2, within(1e-9));
        assertThat(opponent.position().y()).isCloseTo(9.2, within(1e-9));
    }

    private Player join(String team, int number) throws JoinRefusedException {
        return teams.join(team, number, world.addRobot(RobotType.TYPE_0));
    }
}
