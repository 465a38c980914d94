package org.robonewbie.competition.contest;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ScoringTableTest {

    private static final Contest SCORING = Contests.scoring(Conditions.of(1), Contests.SCORING_SECONDS);

    /** What teams have done, and the places that they get: goals are seconds, distances metres. */
    static Stream<Arguments> results() {
        return Stream.of(
                Arguments.of("the faster goal is better", Map.of("A", goal(80), "B", goal(41.2)), "1 B, 2 A"),
                Arguments.of("any goal beats any distance", Map.of("A", ball(0.01), "B", goal(180)), "1 B, 2 A"),
                Arguments.of("without goal the nearer ball is better", Map.of("A", ball(2), "B", ball(1)), "1 B, 2 A"),
                Arguments.of(
                        "equal goals share a place",
                        Map.of("A", goal(50), "B", goal(50), "C", goal(60)),
                        "1 A, 1 B, 3 C"),
                Arguments.of(
                        "equal distances share a place",
                        Map.of("A", ball(1.5), "B", ball(1.5), "C", goal(9), "D", ball(3)),
                        "1 C, 2 A, 2 B, 4 D"),
                Arguments.of(
                        "what is equal in the table is equal",
                        Map.of("A", ball(1.50004), "B", ball(1.49996)),
                        "1 A, 1 B"),
                Arguments.of("who has lost the trial is last", Map.of("A", lost(0.5), "B", ball(6)), "1 B, 2 A"),
                Arguments.of(
                        "all who have lost it are equal",
                        Map.of("A", lost(0.5), "B", lost(3), "C", ball(6)),
                        "1 C, 2 A, 2 B"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("results")
    void teamsAreRanked(String name, Map<String, TeamResult> results, String expected) {
        Table table = table(results);

        assertThat(table.rows())
                .as(name)
                .extracting(row -> row.rank() + " " + row.team())
                .isEqualTo(List.of(expected.split(", ", -1)));
    }

    @Test
    void tableTellsSecondsMetresAndWhatWentWrong() {
        Table table = table(Map.of("A", goal(41.234), "B", ball(1.5), "C", lost(1)));

        assertThat(table.rows())
                .extracting(Table.Row::cells)
                .containsExactly(
                        List.of("41.23 s", "0.000 m", "0.000 m", "played to the end"),
                        List.of("–", "1.500 m", "0.750 m", "played to the end"),
                        List.of("–", "–", "–", "its program exited before the end of the trial"));
    }

    @Test
    void teamsThatHaveNotPlayedYetStandLast() {
        Table table = SCORING.table(List.of("A", "B"), id -> Optional.empty());

        assertThat(table.rows()).extracting(Table.Row::rank).containsExactly(1, 1);
        assertThat(table.rows()).extracting(row -> row.cells().get(3)).containsOnly("not yet");
    }

    @Test
    void everybodyHasTheSameTrial() {
        List<ContestTrial> trials = SCORING.trials(List.of("A", "B"), id -> Optional.empty());

        assertThat(trials).extracting(ContestTrial::seed).containsExactly(1L, 1L);
        assertThat(trials).extracting(ContestTrial::seconds).containsOnly(180.0);
        assertThat(trials)
                .extracting(trial -> trial.entrants().get(0).places().get(0).pose())
                .containsOnly("-0.5,0.4,-40");
    }

    @Test
    void variedStartsDependOnTheSeedOnly() {
        List<String> first = poses(new Conditions(1, true, Map.of()));
        List<String> other = poses(new Conditions(2, true, Map.of()));

        assertThat(first).hasSize(3).containsOnly(first.get(0)).isEqualTo(poses(new Conditions(1, true, Map.of())));
        assertThat(other).isNotEqualTo(first);
    }

    private static List<String> poses(Conditions conditions) {
        return Contests.scoring(conditions, 180).trials(List.of("A", "B", "C"), id -> Optional.empty()).stream()
                .map(trial -> trial.entrants().get(0).places().get(0).pose())
                .toList();
    }

    private static Table table(Map<String, TeamResult> results) {
        Map<String, TrialResult> trials = new LinkedHashMap<>();
        results.forEach((team, result) -> trials.put(
                "scoring-" + team,
                new TrialResult(
                        "scoring-" + team, 1, 180, List.of(new TeamResult(team, result.ending(), result.figures())))));
        return SCORING.table(results.keySet().stream().sorted().toList(), id -> Optional.ofNullable(trials.get(id)));
    }

    private static TeamResult goal(double seconds) {
        return TeamResult.of(
                "", Ending.PLAYED, Map.of("goalSeconds", seconds, "ballMetres", 0.0, "closestMetres", 0.0));
    }

    private static TeamResult ball(double metres) {
        return TeamResult.of("", Ending.PLAYED, Map.of("ballMetres", metres, "closestMetres", metres / 2));
    }

    private static TeamResult lost(double metres) {
        return TeamResult.of("", Ending.STOPPED, Map.of("ballMetres", metres));
    }
}
