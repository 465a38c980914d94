package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * Round-robin contest of penalty shoot-outs, in which both teams attack and defend. The ball lies 2.5 m in front of the
 * goal; the attacker starts 0.8 m behind the ball, with a lateral offset that differs between rounds but is the same for
 * both teams.
 *
 * @param shootOut numbers of regular and sudden-death rounds
 * @param seconds time limit of an attack in simulated seconds
 * @param conditions seeds
 */
record PenaltyContest(ShootOut shootOut, double seconds, Conditions conditions) implements JudgedContest {

    static final String NAME = "penalties";

    private static final double BALL_METRES = 2.5;
    private static final double RUN_UP_METRES = 0.8;
    private static final double ASIDE_METRES = 0.4;
    private static final double KEEPER_METRES = 0.25;

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public String title() {
        return "Penalty kicks";
    }

    @Override
    public String rule() {
        return "Each team attacks and defends against every other: " + shootOut.rounds() + " rounds of "
                + Math.round(seconds) + " s, then up to " + shootOut.suddenDeathRounds() + " of sudden death.";
    }

    @Override
    public List<ContestTrial> trials(List<String> teams, Results results) {
        List<ContestTrial> trials = new ArrayList<>();
        for (Fixture.Pair pair : Fixture.pairs(teams)) {
            int rounds = shootOut.roundsNeeded(played(pair, results));
            for (int round = 1; round <= rounds; round++) {
                trials.add(trial(pair, round, true));
                trials.add(trial(pair, round, false));
            }
        }
        return List.copyOf(trials);
    }

    @Override
    public Judge judge(ContestTrial trial) {
        return new PenaltyJudge(trial);
    }

    @Override
    public Table table(List<String> teams, Results results) {
        List<Fixture.Pair> pairs = Fixture.pairs(teams);
        List<Fixture> fixtures = pairs.stream()
                .filter(pair -> shootOut.isOver(played(pair, results)))
                .map(pair -> fixture(pair, played(pair, results)))
                .toList();
        return LeagueTable.table(this, teams, fixtures, results, team -> idsOf(pairs, team, results));
    }

    private static Fixture fixture(Fixture.Pair pair, List<ShootOut.Round> played) {
        return new Fixture(
                pair.home(),
                pair.away(),
                played.stream().mapToInt(ShootOut.Round::home).sum(),
                played.stream().mapToInt(ShootOut.Round::away).sum());
    }

    /** Returns the rounds in which both teams have attacked. */
    private static List<ShootOut.Round> played(Fixture.Pair pair, Results results) {
        List<ShootOut.Round> played = new ArrayList<>();
        for (int round = 1; ; round++) {
            Optional<TrialResult> home = results.find(id(pair, round, true));
            Optional<TrialResult> away = results.find(id(pair, round, false));
            if (home.isEmpty() || away.isEmpty()) {
                return played;
            }
            played.add(new ShootOut.Round(goals(home.get(), pair.home()), goals(away.get(), pair.away())));
        }
    }

    private static int goals(TrialResult result, String attacker) {
        return (int) Math.round(result.of(attacker).figure(Judge.GOALS).orElse(0));
    }

    private ContestTrial trial(Fixture.Pair pair, int round, boolean homeAttacks) {
        SoccerParameters parameters = SoccerParameters.beginner()
                .with(SoccerParameter.AUTOMATIC_KICK_OFF, 0)
                .with(SoccerParameter.BEAM_GRACE_TIME, 0);
        double goalLine = parameters.field().length() / 2;
        double ballX = goalLine - BALL_METRES;
        double aside = ASIDE_METRES * (2 * new Random(conditions.seedOf(round)).nextDouble() - 1);
        String attacker = homeAttacks ? pair.home() : pair.away();
        String keeper = homeAttacks ? pair.away() : pair.home();
        return new ContestTrial(
                id(pair, round, homeAttacks),
                conditions.seedOf(pair.number(), round),
                parameters,
                List.of(
                        Entrant.of(attacker, Role.ATTACKER, new StartPlace(2, ballX - RUN_UP_METRES, aside, 0)),
                        Entrant.of(keeper, Role.GOALKEEPER, new StartPlace(1, KEEPER_METRES - goalLine, 0, 0))),
                seconds,
                TeamSide.LEFT,
                Optional.of(new Vector3(ballX, 0, parameters.get(SoccerParameter.BALL_RADIUS))),
                false);
    }

    private static String id(Fixture.Pair pair, int round, boolean homeAttacks) {
        return NAME + "-" + pair.home() + "-" + pair.away() + "-" + round + (homeAttacks ? "a" : "b");
    }

    private static List<String> idsOf(List<Fixture.Pair> pairs, String team, Results results) {
        return pairs.stream()
                .filter(pair -> pair.home().equals(team) || pair.away().equals(team))
                .flatMap(pair -> IntStream.rangeClosed(1, played(pair, results).size())
                        .boxed()
                        .flatMap(round -> Stream.of(id(pair, round, true), id(pair, round, false))))
                .toList();
    }
}
