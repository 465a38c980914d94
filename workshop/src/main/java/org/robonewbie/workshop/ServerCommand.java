package org.robonewbie.workshop;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import org.robonewbie.workshop.load.LoadSettings;
import org.robonewbie.workshop.load.MatchLoad;
import org.robonewbie.workshop.load.MatchLoadResult;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Option;

/** Load test of a server with complete matches. */
@Command(
        name = "server",
        description =
                "Play full matches with many robots over TCP, to check whether the server keeps up with real time.",
        footer = {
            "",
            "Examples:",
            "  bench server                 11 against 11 for 10 minutes in real time",
            "  bench server --fast --matches 3"
        })
final class ServerCommand implements Callable<Integer> {

    @Option(
            names = "--robots",
            paramLabel = "N",
            defaultValue = "22",
            description = "Robots on the pitch, 2 to 22 (default: 22).")
    private int robots;

    @Option(
            names = "--seconds",
            paramLabel = "T",
            defaultValue = "600",
            description = "Length of a match, both halves together, in simulated seconds (default: 600).")
    private double seconds;

    @Option(
            names = "--matches",
            paramLabel = "N",
            defaultValue = "1",
            description = "Number of consecutive matches on one server (default: 1).")
    private int matches;

    @Option(names = "--fast", description = "Wait for all robots and run as fast as possible instead of in real time.")
    private boolean fast;

    /** Plays the matches and prints their cost; the exit code is 1 if the simulation missed a cycle. */
    @Override
    public Integer call() throws IOException {
        if (!(seconds >= 1) || Double.isInfinite(seconds)) {
            throw new IllegalArgumentException("--seconds must be at least 1, not " + seconds + ".");
        }
        LoadSettings load = new LoadSettings(
                Bench.checked("--robots", robots, 2, Bench.MAX_ROBOTS),
                seconds,
                Bench.checked("--matches", matches, 1, Integer.MAX_VALUE),
                !fast);
        List<MatchLoadResult> results = new MatchLoad(load, System.out).run();
        System.out.println(MatchLoadResult.TITLE);
        results.forEach(result -> System.out.println(result.toLine()));
        boolean inTime = results.stream().allMatch(result -> result.missedCycles() == 0);
        return inTime ? ExitCode.OK : ExitCode.SOFTWARE;
    }
}
