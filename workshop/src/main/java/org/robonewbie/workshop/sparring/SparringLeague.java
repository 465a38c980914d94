package org.robonewbie.workshop.sparring;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.Journal;
import org.robonewbie.trial.batch.ThreadRunner;

/** Plays matches between chosen pairs of teams, in parallel, and prints a table. An interrupted league continues later. */
public final class SparringLeague {

    private final int players;
    private final double seconds;
    private final int threads;
    private final Optional<Path> journal;
    private final PrintStream out;

    /**
     * Creates a league.
     *
     * @param players number of players of each team
     * @param seconds length of a half on the game's clock, in seconds
     * @param threads number of matches that are played at the same time
     * @param journal file that keeps the results, so that the league can continue later; empty for none
     * @param out destination of the table
     */
    public SparringLeague(int players, double seconds, int threads, Optional<Path> journal, PrintStream out) {
        this.players = players;
        this.seconds = seconds;
        this.threads = threads;
        this.journal = journal;
        this.out = out;
    }

    /**
     * Plays all matches and prints the table.
     *
     * @param pairs pairs of team names, such as {@code team:kickers}
     * @param seeds number of matches of each pair
     * @param firstSeed seed of the first match of each pair
     * @param cache folder for the classes of the fixed teams
     * @throws IOException if a file cannot be read or written
     * @throws IllegalArgumentException if there is no such team, or if the fixed teams cannot be built
     */
    public void play(List<String> pairs, int seeds, long firstSeed, Path cache) throws IOException {
        List<SparringMatch> matches = new ArrayList<>();
        for (long seed = firstSeed; seed < firstSeed + seeds; seed++) {
            for (String pair : pairs) {
                matches.add(match(pair, seed));
            }
        }
        Supplier<FrozenTeam> frozen = frozen(matches, cache);
        out.print(SparringTable.of(quietly(matches, frozen)));
    }

    /** Loads the fixed teams if a match needs them. */
    private static Supplier<FrozenTeam> frozen(List<SparringMatch> matches, Path cache) throws IOException {
        boolean needed = matches.stream()
                .anyMatch(match -> match.first().isFrozen() || match.second().isFrozen());
        if (!needed) {
            return () -> {
                throw new IllegalStateException("No match needs the fixed teams.");
            };
        }
        FrozenTeam loaded = FrozenTeam.load(cache, Path.of("").toAbsolutePath());
        return () -> loaded;
    }

    private SparringMatch match(String pair, long seed) {
        String[] teams = pair.split(":", -1);
        if (teams.length != 2) {
            throw new IllegalArgumentException("\"" + pair + "\" is not a pair of teams. Write it as team:kickers.");
        }
        SparringTeam first = SparringTeam.of(teams[0]);
        if (first == SparringTeam.NOBODY) {
            throw new IllegalArgumentException("The first team of a pair needs players, so it cannot be nobody.");
        }
        return new SparringMatch(first, SparringTeam.of(teams[1]), seed, players, seconds);
    }

    /** Plays the matches while the players' log is discarded. */
    private List<SparringMatch.Result> quietly(List<SparringMatch> matches, Supplier<FrozenTeam> frozen)
            throws IOException {
        PrintStream usual = System.out;
        System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));
        try {
            return journal.isPresent()
                    ? resume(matches, frozen, journal.get())
                    : playAll(matches, frozen, result -> {});
        } finally {
            System.setOut(usual);
        }
    }

    private List<SparringMatch.Result> resume(List<SparringMatch> matches, Supplier<FrozenTeam> frozen, Path file)
            throws IOException {
        try (Journal kept = Journal.open(file, header())) {
            Map<String, String> known = new HashMap<>();
            for (String line : kept.lines()) {
                String[] parts = line.split("\t", 2);
                known.put(parts[0], parts.length > 1 ? parts[1] : "");
            }
            List<SparringMatch> missing = matches.stream()
                    .filter(match -> !known.containsKey(match.key()))
                    .toList();
            List<SparringMatch.Result> results = new ArrayList<>();
            for (SparringMatch match : matches) {
                if (known.containsKey(match.key())) {
                    String[] figures =
                            Objects.requireNonNull(known.get(match.key())).split("\t", -1);
                    results.add(
                            new SparringMatch.Result(match, TeamFigures.of(figures[0]), TeamFigures.of(figures[1])));
                }
            }
            results.addAll(playAll(missing, frozen, result -> kept.add(line(result))));
            results.sort(Comparator.comparingInt(result -> matches.indexOf(result.match())));
            return results;
        }
    }

    private String header() {
        return "Halves of " + seconds + " s with " + players + " players";
    }

    private static String line(SparringMatch.Result result) {
        return result.match().key() + "\t" + result.first() + "\t" + result.second();
    }

    /** Receives each result as soon as its match is over. */
    @FunctionalInterface
    private interface ResultReceiver {
        void accept(SparringMatch.Result result) throws IOException;
    }

    private List<SparringMatch.Result> playAll(
            List<SparringMatch> matches, Supplier<FrozenTeam> frozen, ResultReceiver receiver) throws IOException {
        try (BatchRunner runner = new ThreadRunner(threads);
                BatchProgress progress = BatchProgress.of("halves", matches.size(), 0)) {
            return runner.run(matches, match -> match.play(frozen), (match, result) -> {
                receiver.accept(result);
                progress.print(System.err::println, SparringTable.line(result));
                progress.advance(false);
            });
        }
    }
}
