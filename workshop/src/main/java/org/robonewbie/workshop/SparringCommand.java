package org.robonewbie.workshop;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.workshop.sparring.SparringLeague;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Option;

/** Matches of the example team against fixed sparring partners. */
@Command(
        name = "sparring",
        description = "Play halves between the example team and fixed sparring partners, on the game's clock.",
        sortOptions = false,
        footer = {
            "",
            "Teams:",
            "  team      the example team as it is",
            "  before    the example team at commit efba2916, compiled with the framework as it is",
            "  kickers   kicks at once whenever it is at the ball",
            "  pack      the three players nearest to the ball dribble",
            "  wall      all players defend",
            "  nobody    the first team of the pair plays alone",
            "",
            "The teams other than team use the skills of commit efba2916. The first run needs Git, the full history",
            "and a JDK to compile that commit.",
            "",
            "Examples:",
            "  bench sparring                                     eleven players, two halves against each partner",
            "  bench sparring --pairs team:kickers --players 5 --seconds 100 --seeds 4    a quick look",
            "  bench sparring --pairs team:nobody --players 1 --seeds 10                  how often does one player score?",
            "  bench sparring --seeds 10 --first-seed 9001 --threads 2 --journal league.journal",
            "",
            "With --journal, the same command continues after an interruption, and more seeds or pairs can be added.",
            "Delete the journal after a change of the team."
        })
final class SparringCommand implements Callable<Integer> {

    private static final int MAX_THREADS = 64;

    @Option(
            names = "--pairs",
            paramLabel = "A:B",
            split = ",",
            description = "Pairs of teams (default: team:before,team:kickers,team:pack,team:wall).")
    private List<String> pairs = List.of("team:before", "team:kickers", "team:pack", "team:wall");

    @Option(names = "--players", paramLabel = "N", description = "Players per team, 1 to 11 (default: 11).")
    private int players = 11;

    @Option(names = "--seconds", paramLabel = "T", description = "Length of a half in seconds (default: 300).")
    private double seconds = 300;

    @Option(names = "--seeds", paramLabel = "N", description = "Number of halves of each pair (default: 2).")
    private int seeds = 2;

    @Option(names = "--first-seed", paramLabel = "N", description = "Seed of the first half (default: 1).")
    private long firstSeed = 1;

    @Option(
            names = "--threads",
            paramLabel = "N",
            description = "Number of halves played at the same time, 1 to 64 (default: 1).")
    private int threads = 1;

    @Option(names = "--journal", paramLabel = "FILE", description = "Keep the results of finished halves in this file.")
    private Optional<Path> journal = Optional.empty();

    @Option(
            names = "--cache",
            paramLabel = "FOLDER",
            description = "Folder for compiled teams (default: .robonewbie/sparring in the home folder).")
    private Path cache = Path.of(System.getProperty("user.home", "."), ".robonewbie", "sparring");

    @Override
    public Integer call() throws IOException {
        Bench.checked("--players", players, 1, 11);
        Bench.checked("--seeds", seeds, 1, Integer.MAX_VALUE);
        Bench.checked("--threads", threads, 1, MAX_THREADS);
        Bench.checkSeconds("--seconds", seconds);
        new SparringLeague(players, seconds, threads, journal, System.out).play(pairs, seeds, firstSeed, cache);
        return ExitCode.OK;
    }
}
