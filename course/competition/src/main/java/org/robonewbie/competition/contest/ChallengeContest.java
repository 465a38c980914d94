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
 * Contest in which each team attempts a challenge alone on the pitch, in one or more rounds. Conditions are the same for all
 * teams.
 *
 * @param name name on the command line, one word
 * @param title display title
 * @param rule scoring rule, in one or two sentences
 * @param challenge supplies a new challenge for each trial
 * @param start start pose that is passed to the programs
 * @param seconds length of a trial in simulated seconds
 * @param rounds trials per team; the seed increases by one with each round
 * @param criteria columns of the table; each column breaks ties in the preceding ones
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

    /** A team's totals, with one value per criterion. */
    private record Total(String team, List<Double> values, String last, boolean compiled, long played) {}

    /** Creates the contest. */
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
