package org.robonewbie.competition.contest;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * League table: three points for a win, one for a draw. Ties are broken by goal difference, then by goals scored, then by
 * points and goal difference in the fixtures among the tied teams. Teams that are still tied share a rank.
 */
final class LeagueTable {

    private static final List<String> COLUMNS =
            List.of("Played", "Won", "Drawn", "Lost", "Goals", "Difference", "Points");

    private static final String POINTS =
            " Three points for a win, one for a draw; then goal difference, goals, then points and goal difference among"
                    + " the tied teams.";

    private LeagueTable() {}

    /** A team's wins, draws, losses and goals. */
    record Line(String team, int won, int drawn, int lost, int goals, int against) {

        int points() {
            return 3 * won + drawn;
        }

        int difference() {
            return goals - against;
        }

        List<String> cells() {
            return List.of(
                    String.valueOf(won + drawn + lost),
                    String.valueOf(won),
                    String.valueOf(drawn),
                    String.valueOf(lost),
                    goals + ":" + against,
                    difference() > 0 ? "+" + difference() : String.valueOf(difference()),
                    String.valueOf(points()));
        }

        private Line plus(int own, int other) {
            return new Line(
                    team,
                    won + (own > other ? 1 : 0),
                    drawn + (own == other ? 1 : 0),
                    lost + (own < other ? 1 : 0),
                    goals + own,
                    against + other);
        }
    }

    /**
     * Creates the table of a contest.
     *
     * @param contest contest, which supplies the title and the rule
     * @param teams all teams
     * @param fixtures results of the finished fixtures
     * @param results results of the finished trials
     * @param trialsOf returns the names of a team's trials
     */
    static Table table(
            Contest contest,
            List<String> teams,
            List<Fixture> fixtures,
            Results results,
            Function<String, List<String>> trialsOf) {
        Predicate<String> compiled = team -> results.hasCompiled(team, trialsOf.apply(team));
        List<Table.Row> rows = of(teams, fixtures, compiled).stream()
                .map(place -> new Table.Row(
                        place.rank(),
                        place.who().team(),
                        place.who().cells(),
                        trialsOf.apply(place.who().team()),
                        results.hasPlayed(
                                place.who().team(), trialsOf.apply(place.who().team()))))
                .toList();
        return new Table(contest.title(), contest.rule() + POINTS, COLUMNS, rows);
    }

    /** Ranks teams by their finished fixtures; teams whose programs do not compile are last. */
    static List<Ranked<Line>> of(List<String> teams, List<Fixture> fixtures, Predicate<String> compiled) {
        List<Line> lines = teams.stream().map(team -> line(team, fixtures)).toList();
        Comparator<Line> inAll = Comparator.comparing((Line line) -> !compiled.test(line.team()))
                .thenComparing(Comparator.comparingInt(Line::points)
                        .thenComparingInt(Line::difference)
                        .thenComparingInt(Line::goals)
                        .reversed());
        Map<String, Line> amongEquals = lines.stream()
                .collect(Collectors.toMap(
                        Line::team, line -> line(line.team(), between(equals(line, lines, inAll), fixtures))));
        return Ranked.ranking(
                lines,
                inAll.thenComparing(
                        line -> amongEquals.getOrDefault(line.team(), line),
                        Comparator.comparingInt(Line::points)
                                .thenComparingInt(Line::difference)
                                .reversed()));
    }

    private static Set<String> equals(Line line, List<Line> lines, Comparator<Line> order) {
        return lines.stream()
                .filter(other -> order.compare(line, other) == 0)
                .map(Line::team)
                .collect(Collectors.toSet());
    }

    private static List<Fixture> between(Set<String> teams, List<Fixture> fixtures) {
        return fixtures.stream()
                .filter(fixture -> teams.contains(fixture.home()) && teams.contains(fixture.away()))
                .toList();
    }

    private static Line line(String team, List<Fixture> fixtures) {
        Line line = new Line(team, 0, 0, 0, 0, 0);
        for (Fixture fixture : fixtures) {
            if (fixture.home().equals(team)) {
                line = line.plus(fixture.homeGoals(), fixture.awayGoals());
            } else if (fixture.away().equals(team)) {
                line = line.plus(fixture.awayGoals(), fixture.homeGoals());
            }
        }
        return line;
    }
}
