package org.robonewbie.competition.contest;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Stream;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * A contest in which each team has one trial, alone on the pitch, under the same conditions as all others: the same start place
 * and the same seed.
 *
 * @param name one word
 * @param title for people
 * @param rule how it is judged
 * @param start where the robot starts
 * @param seconds simulated seconds of a trial
 * @param judges makes the judge of a team's trial
 * @param criteria by what teams are compared, the most important first
 * @param conditions seeds and variations
 */
public record SoloContest(
        String name,
        String title,
        String rule,
        StartPlace start,
        double seconds,
        Function<ContestTrial, Judge> judges,
        List<Criterion> criteria,
        Conditions conditions)
        implements JudgedContest {

    private static final double VARIED_METRES = 0.3;
    private static final double VARIED_DEGREES = 20;

    /** Makes the list unmodifiable. */
    public SoloContest {
        criteria = List.copyOf(criteria);
    }

    @Override
    public List<ContestTrial> trials(List<String> teams, Results results) {
        return teams.stream().map(this::trial).toList();
    }

    @Override
    public Judge judge(ContestTrial trial) {
        return judges.apply(trial);
    }

    @Override
    public Table table(List<String> teams, Results results) {
        List<Optional<TeamResult>> found = teams.stream()
                .map(team -> results.find(id(team)).map(result -> result.of(team)))
                .toList();
        List<TeamResult> ready = found.stream().flatMap(Optional::stream).toList();
        List<Table.Row> rows =
                Ranked.ranking(ready, order()).stream().map(this::row).toList();
        List<Table.Row> waiting = teams.stream()
                .filter(team -> ready.stream().noneMatch(result -> result.team().equals(team)))
                .map(team -> new Table.Row(ready.size() + 1, team, cells("not yet"), List.of()))
                .toList();
        return new Table(
                title,
                rule,
                Stream.concat(criteria.stream().map(Criterion::title), Stream.of("Trial"))
                        .toList(),
                Stream.concat(rows.stream(), waiting.stream()).toList());
    }

    private ContestTrial trial(String team) {
        SoccerParameters parameters = SoccerParameters.beginner()
                .with(SoccerParameter.AUTOMATIC_KICK_OFF, 0)
                .with(SoccerParameter.BEAM_GRACE_TIME, 0);
        return new ContestTrial(
                id(team),
                conditions.seedOf(team),
                parameters,
                List.of(Entrant.of(team, Role.MAIN, startPlace())),
                seconds,
                TeamSide.LEFT,
                Optional.empty());
    }

    private String id(String team) {
        return name + "-" + team;
    }

    /** The same place for all, or another same place for all with each seed. */
    private StartPlace startPlace() {
        if (!conditions.varied()) {
            return start;
        }
        Random random = new Random(conditions.seed());
        return new StartPlace(
                start.number(),
                start.x() - VARIED_METRES * random.nextDouble(),
                start.y() + VARIED_METRES * (2 * random.nextDouble() - 1),
                start.degrees() + VARIED_DEGREES * (2 * random.nextDouble() - 1));
    }

    /** A team that has lost the trial ranks behind all others. */
    private Comparator<TeamResult> order() {
        Comparator<TeamResult> order = Comparator.comparing(result -> !result.isPlayed());
        for (Criterion criterion : criteria) {
            order = order.thenComparing(criterion.order());
        }
        return order;
    }

    private Table.Row row(Ranked<TeamResult> place) {
        TeamResult result = place.who();
        List<String> cells = Stream.concat(
                        criteria.stream().map(criterion -> criterion.text(result)),
                        Stream.of(result.ending().sentence()))
                .toList();
        return new Table.Row(place.rank(), result.team(), cells, List.of(id(result.team())));
    }

    private List<String> cells(String last) {
        return Stream.concat(criteria.stream().map(criterion -> Criterion.NOTHING), Stream.of(last))
                .toList();
    }
}
