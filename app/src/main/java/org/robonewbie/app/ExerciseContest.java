package org.robonewbie.app;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robonewbie.competition.contest.Contest;
import org.robonewbie.competition.contest.Entrant;
import org.robonewbie.competition.contest.Judge;
import org.robonewbie.competition.contest.Place;
import org.robonewbie.competition.contest.Results;
import org.robonewbie.competition.contest.Role;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.Trial;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Score;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * An exercise as a contest: each team solves it with the same seeds, judged by the checker that also grades at home. Most points
 * win; teams with equal points share a place.
 *
 * @param exercise the exercise
 * @param seed of the first trial; the next ones follow it
 * @param rounds trials of each team
 */
record ExerciseContest(Exercise exercise, long seed, int rounds) implements Contest {

    /** What stands before the name of an exercise on the command line. */
    static final String PREFIX = "exercise:";

    /** Points of a trial, 0 to 10. */
    static final String POINTS = "points";

    /** 1 if the exercise was solved, else 0. */
    static final String PASSED = "passed";

    private record Total(String team, double points, int passed, String last, List<String> trials) {}

    @Override
    public String name() {
        return "exercise-" + exercise.name();
    }

    @Override
    public String title() {
        return "Exercise " + exercise.number() + ": " + exercise.title();
    }

    @Override
    public String rule() {
        return exercise.goal() + " " + rounds + (rounds == 1 ? " trial" : " trials") + " of 0 to " + Score.MOST_POINTS
                + " points; the most points win, equal points share a place.";
    }

    @Override
    public List<Trial> trials(List<String> teams, Results results) {
        List<Trial> trials = new ArrayList<>();
        for (int round = 1; round <= rounds; round++) {
            for (String team : teams) {
                trials.add(trial(team, round));
            }
        }
        return trials;
    }

    private Trial trial(String team, int round) {
        return new Trial(
                id(team, round),
                seed + round - 1,
                SoccerParameters.beginner(),
                List.of(Entrant.of(team, Role.MAIN, new StartPlace(1, -1, 0, 0))),
                exercise.seconds(),
                TeamSide.LEFT,
                Optional.empty());
    }

    private String id(String team, int round) {
        return name() + "-" + team + "-" + round;
    }

    @Override
    public Judge judge(Trial trial) {
        throw new IllegalStateException("The checker of the exercise judges, see ExerciseTrials.");
    }

    @Override
    public Table table(List<String> teams, Results results) {
        List<Total> totals = teams.stream().map(team -> total(team, results)).toList();
        List<Table.Row> rows = Place.ranking(totals, Comparator.comparingDouble(total -> -total.points())).stream()
                .map(this::row)
                .toList();
        return new Table(title(), rule(), List.of("Points", "Passed", "Last trial"), rows);
    }

    private Total total(String team, Results results) {
        List<String> trials = IntStream.rangeClosed(1, rounds)
                .mapToObj(round -> id(team, round))
                .toList();
        List<TeamResult> found = trials.stream()
                .flatMap(id -> results.find(id).stream())
                .map(result -> result.of(team))
                .toList();
        double points = found.stream()
                .mapToDouble(result -> result.figure(POINTS).orElse(0))
                .sum();
        double passed = found.stream()
                .mapToDouble(result -> result.figure(PASSED).orElse(0))
                .sum();
        String last = found.isEmpty()
                ? "not yet"
                : found.get(found.size() - 1).ending().sentence();
        return new Total(team, points, (int) passed, last, trials);
    }

    private Table.Row row(Place<Total> place) {
        Total total = place.who();
        List<String> cells = List.of(
                String.format(Locale.ROOT, "%.0f of %d", total.points(), rounds * Score.MOST_POINTS),
                total.passed() + " of " + rounds,
                total.last());
        return new Table.Row(place.rank(), total.team(), cells, total.trials());
    }
}
