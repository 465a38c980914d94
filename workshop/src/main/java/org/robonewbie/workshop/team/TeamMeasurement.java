package org.robonewbie.workshop.team;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.ToIntFunction;
import org.robonewbie.agent.Agent;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.team.Agent_Team;
import org.robonewbie.workshop.team.TeamMatch.Result;

/** Plays matches of the example team on the league pitch: with a single player, or with equal numbers on both sides. */
public final class TeamMeasurement {

    /** Default opponent. */
    public static final String DEFAULT_OPPONENT = "Agent_BetterSoccer";

    private static final Map<String, IntFunction<Agent>> OPPONENTS =
            Map.of(DEFAULT_OPPONENT, number -> new Agent_BetterSoccer(), "Agent_Team", Agent_Team::new);

    private static final double HALF_SECONDS = 300;

    private final int halves;
    private final long firstSeed;
    private final PrintStream out;

    /**
     * Creates a measurement.
     *
     * @param halves number of halves
     * @param firstSeed seed of the first half
     * @param out destination of the table
     */
    public TeamMeasurement(int halves, long firstSeed, PrintStream out) {
        this.halves = halves;
        this.firstSeed = firstSeed;
        this.out = out;
    }

    /**
     * Plays halves of five minutes on the game's clock.
     *
     * @param players players of each team; 1 for a single player without opponents
     * @param opponent class name of the opponents
     * @throws IllegalArgumentException if there is no such opponent
     */
    public void run(int players, String opponent) {
        IntFunction<Agent> others = Optional.ofNullable(OPPONENTS.get(opponent))
                .orElseThrow(() -> new IllegalArgumentException(
                        "--against must be Agent_BetterSoccer or Agent_Team, not " + opponent + "."));
        List<Result> results = new ArrayList<>();
        for (long seed = firstSeed; seed < firstSeed + halves; seed++) {
            Result result = quietly(players, seed, others);
            results.add(result);
            out.println(String.format(
                    Locale.ROOT,
                    "%2d v %-2d seed %-5d %2d : %-2d   falls %3d (others %3d)   kicks %2d   passes %2d, reached %2d",
                    players,
                    players == 1 ? 0 : players,
                    seed,
                    result.goals(),
                    result.against(),
                    result.falls(),
                    result.opponentsFalls(),
                    result.kicks(),
                    result.passesTried(),
                    result.passesReached()));
        }
        out.println(summary(results, players));
    }

    private static String summary(List<Result> results, int players) {
        long wins =
                results.stream().filter(each -> each.goals() > each.against()).count();
        long draws =
                results.stream().filter(each -> each.goals() == each.against()).count();
        return String.format(
                Locale.ROOT,
                "total: %d won, %d drawn, %d lost; goals %.1f : %.1f; falls per player %.1f, per"
                        + " opponent %.1f; kicks %.1f; passes %.1f, reached %.1f",
                wins,
                draws,
                results.size() - wins - draws,
                mean(results, Result::goals),
                mean(results, Result::against),
                mean(results, Result::falls) / players,
                mean(results, Result::opponentsFalls) / players,
                mean(results, Result::kicks),
                mean(results, Result::passesTried),
                mean(results, Result::passesReached));
    }

    private static double mean(List<Result> results, ToIntFunction<Result> value) {
        return results.stream().mapToInt(value).average().orElse(0);
    }

    private static Result quietly(int players, long seed, IntFunction<Agent> others) {
        PrintStream usual = System.out;
        System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));
        try {
            return TeamMatch.play(seed, players, players == 1 ? 0 : players, Agent_Team::new, others, HALF_SECONDS);
        } finally {
            System.setOut(usual);
        }
    }
}
