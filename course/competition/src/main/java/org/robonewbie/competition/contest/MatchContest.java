package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Round-robin contest of matches. A team whose program fails forfeits the match: it loses 0–3, or by more if it was more
 * than three goals behind. If both programs fail, neither team gets points.
 *
 * @param kind pitch, rules and number of fixtures per pair of teams
 * @param players robots per team, 1 to 11
 * @param seconds length of a match in simulated seconds; a match has only one half
 * @param conditions seeds
 */
public record MatchContest(MatchKind kind, int players, double seconds, Conditions conditions)
        implements JudgedContest {

    private static final int FORFEIT_GOALS = 3;

    /** Start positions by robot number, all outside the centre circle. */
    private static final double[][] LINE_UP = {
        {-5, 0},
        {-1.6, 0},
        {-1.8, 2},
        {-1.8, -2},
        {-3, 0},
        {-3, -1.5},
        {-3, 1.5},
        {-4, -2},
        {-4, 0},
        {-4, 2},
        {-2.3, 0.8}
    };

    @Override
    public String name() {
        return kind.word();
    }

    @Override
    public String title() {
        return kind.title() + ", " + players + " against " + players;
    }

    @Override
    public String rule() {
        return kind.pairing() + " for " + Math.round(seconds) + " s.";
    }

    @Override
    public List<ContestTrial> trials(List<String> teams, Results results) {
        return kind.pairs(teams).stream().map(this::trial).toList();
    }

    @Override
    public Judge judge(ContestTrial trial) {
        return new MatchJudge(trial);
    }

    @Override
    public Table table(List<String> teams, Results results) {
        List<Fixture.Pair> pairs = kind.pairs(teams);
        List<Fixture> fixtures = pairs.stream()
                .flatMap(pair -> results.find(id(pair)).map(result -> fixture(pair, result)).stream())
                .flatMap(Optional::stream)
                .toList();
        return LeagueTable.table(this, teams, fixtures, results, team -> idsOf(pairs, team, results));
    }

    /** Returns the official result; empty if both programs failed. */
    static Optional<Fixture> fixture(Fixture.Pair pair, TrialResult result) {
        TeamResult home = result.of(pair.home());
        TeamResult away = result.of(pair.away());
        if (!home.isPlayed() && !away.isPlayed()) {
            return Optional.empty();
        }
        int homeGoals = goals(home);
        int awayGoals = goals(away);
        if (!home.isPlayed()) {
            return Optional.of(
                    new Fixture(pair.home(), pair.away(), 0, Math.max(FORFEIT_GOALS, awayGoals - homeGoals)));
        }
        if (!away.isPlayed()) {
            return Optional.of(
                    new Fixture(pair.home(), pair.away(), Math.max(FORFEIT_GOALS, homeGoals - awayGoals), 0));
        }
        return Optional.of(new Fixture(pair.home(), pair.away(), homeGoals, awayGoals));
    }

    private static int goals(TeamResult result) {
        return (int) Math.round(result.figures().getOrDefault(Judge.GOALS, 0.0));
    }

    private ContestTrial trial(Fixture.Pair pair) {
        return new ContestTrial(
                id(pair),
                conditions.seedOf(pair.number()),
                kind.parameters(seconds),
                List.of(entrant(pair.home()), entrant(pair.away())),
                seconds,
                kind.kickOff(pair),
                Optional.empty(),
                kind.hasOwnPlaces());
    }

    private Entrant entrant(String team) {
        return new Entrant(
                team,
                Role.MAIN,
                IntStream.range(0, players)
                        .mapToObj(i -> new StartPlace(i + 1, LINE_UP[i][0], LINE_UP[i][1], 0))
                        .toList());
    }

    private String id(Fixture.Pair pair) {
        return kind.word() + "-" + pair.home() + "-" + pair.away();
    }

    private List<String> idsOf(List<Fixture.Pair> pairs, String team, Results results) {
        return pairs.stream()
                .filter(pair -> pair.home().equals(team) || pair.away().equals(team))
                .map(this::id)
                .filter(id -> results.find(id).isPresent())
                .toList();
    }
}
