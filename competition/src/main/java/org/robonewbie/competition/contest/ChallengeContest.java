package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.Challenge;

/**
 * A challenge, such as an exercise, as a contest: each team tries it with the same seeds. The largest sum of the first figure
 * wins; teams with equal sums share a place.
 *
 * @param name one word, as it stands on the command line
 * @param title a title for people
 * @param rule how it is judged, in one or two sentences
 * @param challenge makes the challenge of each trial
 * @param seconds simulated time of a trial
 * @param seed of the first trial; the next ones follow it
 * @param rounds trials of each team
 * @param columns what the table shows; the first one decides
 */
public record ChallengeContest(
        String name,
        String title,
        String rule,
        Supplier<? extends Challenge> challenge,
        double seconds,
        long seed,
        int rounds,
        List<Column> columns)
        implements Contest {

    /**
     * A column of the table: the sum of a figure over all trials of a team.
     *
     * @param figure name of the figure
     * @param title head of the column
     * @param most what can be reached in a trial
     */
    public record Column(String figure, String title, int most) {}

    private record Total(String team, List<Double> sums, String last, List<String> trials) {}

    /** Copies the list. */
    public ChallengeContest {
        columns = List.copyOf(columns);
    }

    @Override
    public List<ContestTrial> trials(List<String> teams, Results results) {
        List<ContestTrial> trials = new ArrayList<>();
        for (int round = 1; round <= rounds; round++) {
            for (String team : teams) {
                trials.add(trial(team, round));
            }
        }
        return trials;
    }

    private ContestTrial trial(String team, int round) {
        return new ContestTrial(
                id(team, round),
                seed + round - 1,
                SoccerParameters.beginner(),
                List.of(Entrant.of(team, Role.MAIN, new StartPlace(1, -1, 0, 0))),
                seconds,
                TeamSide.LEFT,
                Optional.empty());
    }

    private String id(String team, int round) {
        return name + "-" + team + "-" + round;
    }

    @Override
    public Table table(List<String> teams, Results results) {
        List<Total> totals = teams.stream().map(team -> total(team, results)).toList();
        Comparator<Total> order =
                Comparator.comparingDouble(total -> -total.sums().get(0));
        List<Table.Row> rows =
                Ranked.ranking(totals, order).stream().map(this::row).toList();
        List<String> heads = Stream.concat(columns.stream().map(Column::title), Stream.of("Last trial"))
                .toList();
        return new Table(title, rule, heads, rows);
    }

    private Total total(String team, Results results) {
        List<String> trials = IntStream.rangeClosed(1, rounds)
                .mapToObj(round -> id(team, round))
                .toList();
        List<TeamResult> found = trials.stream()
                .flatMap(id -> results.find(id).stream())
                .map(result -> result.of(team))
                .toList();
        List<Double> sums = columns.stream()
                .map(column -> found.stream()
                        .mapToDouble(result -> result.figure(column.figure()).orElse(0))
                        .sum())
                .toList();
        String last = found.isEmpty()
                ? "not yet"
                : found.get(found.size() - 1).ending().sentence();
        return new Total(team, sums, last, trials);
    }

    private Table.Row row(Ranked<Total> place) {
        Total total = place.who();
        List<String> cells = new ArrayList<>();
        for (int i = 0; i < columns.size(); i++) {
            int most = rounds * columns.get(i).most();
            cells.add(String.format(Locale.ROOT, "%.0f of %d", total.sums().get(i), most));
        }
        cells.add(total.last());
        return new Table.Row(place.rank(), total.team(), cells, total.trials());
    }
}
