package org.robonewbie.competition.contest;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.soccer.SoccerParameter;

class LeagueTableTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "A-B 1:0, A-C 1:0, B-C 1:0 | 1 A 6, 2 B 3, 3 C 0",
                "A-B 0:0, A-C 0:0, B-C 0:0 | 1 A 2, 1 B 2, 1 C 2",
                "A-B 1:0, A-C 0:3, B-C 1:0 | 1 C 3, 2 B 3, 3 A 3",
                "A-B 2:2, A-C 1:1, B-C 1:1 | 1 A 2, 1 B 2, 3 C 2",
                "A-B 0:5, A-C 0:5, B-C 2:2 | 1 B 4, 1 C 4, 3 A 0",
                "A-B 1:0 | 1 A 3, 2 C 0, 3 B 0",
                "A-B 0:1, A-C 2:1, C-A 2:1, B-C 1:2, C-B 2:1 | 1 C 9, 2 B 3, 3 A 3"
            })
    void pointsThenDifferenceThenGoalsThenMeetingsDecide(String games, String expected) {
        List<Fixture> fixtures = Arrays.stream(games.split(", ", -1))
                .map(LeagueTableTest::fixture)
                .toList();

        List<String> places = LeagueTable.of(List.of("A", "B", "C"), fixtures, team -> true).stream()
                .map(place -> place.rank() + " " + place.who().team() + " " + points(place))
                .toList();

        assertThat(places).isEqualTo(List.of(expected.split(", ", -1)));
    }

    @Test
    void eachTeamMeetsEachOtherOneOnce() {
        List<Fixture.Pair> pairs = Fixture.pairs(List.of("A", "B", "C", "D"));

        assertThat(pairs)
                .extracting(pair -> pair.home() + pair.away())
                .containsExactly("AB", "AC", "AD", "BC", "BD", "CD");
    }

    @Test
    void inALeagueTwoTeamsMeetTwiceWithChangedSidesUnderTheLeaguesRules() {
        List<ContestTrial> trials = new MatchContest(MatchKind.LEAGUE, 3, 300, Conditions.of(1))
                .trials(List.of("A", "B", "C"), id -> Optional.empty());

        assertThat(trials)
                .extracting(ContestTrial::id)
                .containsExactly("league-A-B", "league-A-C", "league-B-C", "league-B-A", "league-C-A", "league-C-B");
        assertThat(trials).extracting(ContestTrial::seed).doesNotHaveDuplicates();
        assertThat(trials).allSatisfy(trial -> {
            assertThat(trial.robots()).isEqualTo(6);
            assertThat(trial.ownPlaces()).isTrue();
            assertThat(trial.kickOff()).isEqualTo(TeamSide.LEFT);
            assertThat(trial.parameters().field().length()).isEqualTo(30);
            assertThat(trial.parameters().get(SoccerParameter.RULE_HALF_TIME)).isGreaterThan(300);
            assertThat(trial.parameters().get(SoccerParameter.MAX_TOUCH_GROUP_SIZE))
                    .isEqualTo(2);
        });
    }

    @ParameterizedTest
    @CsvSource({
        "PLAYED, 2, PLAYED, 1, 2, 1",
        "STOPPED, 2, PLAYED, 1, 0, 3",
        "STOPPED, 0, PLAYED, 5, 0, 5",
        "PLAYED, 0, SILENT, 1, 3, 0"
    })
    void whoseProgramFailsLosesTheMatch(Ending one, int ones, Ending other, int others, int home, int away) {
        TrialResult result = result(one, ones, other, others);

        assertThat(MatchContest.fixture(new Fixture.Pair("A", "B", 1), result))
                .contains(new Fixture("A", "B", home, away));
    }

    @Test
    void teamThatDoesNotCompileStandsBehindAllThatPlayed() {
        List<Fixture> fixtures = List.of(new Fixture("A", "B", 0, 9), new Fixture("B", "C", 3, 0));

        List<String> places = LeagueTable.of(List.of("A", "B", "C"), fixtures, team -> !team.equals("C")).stream()
                .map(place -> place.rank() + " " + place.who().team())
                .toList();

        assertThat(places).containsExactly("1 B", "2 A", "3 C");
    }

    @Test
    void whereBothFailNobodyGetsAnything() {
        TrialResult result = result(Ending.STOPPED, 1, Ending.SILENT, 0);

        assertThat(MatchContest.fixture(new Fixture.Pair("A", "B", 1), result)).isEmpty();
    }

    private static TrialResult result(Ending one, double ones, Ending other, double others) {
        return new TrialResult(
                "matches-A-B",
                1,
                300,
                List.of(
                        TeamResult.of("A", one, Map.of(MatchJudge.GOALS, ones)),
                        TeamResult.of("B", other, Map.of(MatchJudge.GOALS, others))));
    }

    private static String points(Ranked<LeagueTable.Line> place) {
        List<String> cells = place.who().cells();
        return cells.get(cells.size() - 1);
    }

    private static Fixture fixture(String text) {
        String[] parts = text.split("[- :]", -1);
        return new Fixture(parts[0], parts[1], Integer.parseInt(parts[2]), Integer.parseInt(parts[3]));
    }
}
