package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robonewbie.trial.Challenge;

/**
 * A challenge as a contest: an exercise, or one for this purpose. Each team tries it alone on the pitch, under the same
 * conditions as all others, once or in several rounds.
 *
 * @param name one word, as it stands on the command line
 * @param title a title for people
 * @param rule how it is judged, in one or two sentences
 * @param challenge makes the challenge of each trial
 * @param start what programs are told about where they start
 * @param seconds simulated time of a trial
 * @param rounds trials of each team, each with the next seed
 * @param criteria columns of the table, by which teams are compared, the most important first
 * @param conditions seeds and variations
 */
public record ChallengeContest(
        String name,
        String title,
        String rule,
        Supplier<? extends Challenge> challenge,
        StartPlace start,
        double seconds,
        int rounds,
        List<Criterion> criteria,
        Conditions conditions)
        implements Contest {

    /** What a team has reached, a value for each criterion. */
    private record Total(String team, List<Double> values, String last, boolean compiled, long played) {}

    /** Copies the list. */
    public ChallengeContest {
        criteria = List.copyOf(criteria);
    }

    @Override
    public List<ContestTrial> trials(List<String> teams, Results results) {
        return IntStream.range(0, rounds)
                .boxed()
                .flatMap(round -> teams.stream().map(team -> trial(team, round)))
                .toList();
    }

    private ContestTrial trial(String team, int round) {
        return ContestTrial.alone(
                ids(team).get(round), conditions.seedOf(team) + round, Entrant.of(team, Role.MAIN, start), seconds);
    }

    private List<String> ids(String team) {
        return rounds == 1
                ? List.of(name + "-" + team)
                : IntStream.rangeClosed(1, rounds)
                        .mapToObj(round -> name + "-" + team + "-" + round)
                        .toList();
    }

    @Override
    public Table table(List<String> teams, Results results) {
        List<Total> totals = teams.stream().map(team -> total(team, results)).toList();
        Comparator<Total> order = IntStream.range(0, criteria.size())
                .mapToObj(this::by)
                .reduce(Comparator.comparing(total -> !total.compiled()), Comparator::thenComparing)
                .thenComparing(Comparator.comparingLong(Total::played).reversed());
        List<Table.Row> rows =
                Ranked.ranking(totals, order).stream().map(this::row).toList();
        Stream<String> heads = criteria.stream().map(Criterion::title);
        return new Table(
                title,
                rule,
                Stream.concat(heads, Stream.of(rounds == 1 ? "Trial" : "Last trial"))
                        .toList(),
                rows);
    }

    private Comparator<Total> by(int column) {
        return Comparator.comparingDouble(
                total -> criteria.get(column).order(total.values().get(column)));
    }

    private Total total(String team, Results results) {
        List<Optional<TeamResult>> found = ids(team).stream()
                .map(id -> results.find(id).map(result -> result.of(team)))
                .toList();
        List<Double> values = criteria.stream()
                .map(criterion -> found.stream().mapToDouble(criterion::valueIn).sum())
                .toList();
        String last = found.stream()
                .flatMap(Optional::stream)
                .map(TeamResult::endingInWords)
                .reduce("not yet", (before, next) -> next);
        long played = found.stream()
                .flatMap(Optional::stream)
                .filter(TeamResult::isPlayed)
                .count();
        return new Total(team, values, last, results.hasCompiled(team, ids(team)), played);
    }

    private Table.Row row(Ranked<Total> place) {
        Total total = place.who();
        List<String> cells = new ArrayList<>();
        for (int i = 0; i < criteria.size(); i++) {
            cells.add(criteria.get(i).text(total.values().get(i)));
        }
        cells.add(total.last());
        return new Table.Row(place.rank(), total.team(), cells, ids(total.team()), total.played() > 0);
    }
}
