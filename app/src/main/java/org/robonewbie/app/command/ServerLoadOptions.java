package org.robonewbie.app.command;

import java.io.IOException;
import java.util.List;
import org.robonewbie.bench.load.LoadSettings;
import org.robonewbie.bench.load.MatchLoad;
import org.robonewbie.bench.load.MatchLoadResult;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.world.PhysicsEngine;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Option;

/** How {@code measure server} puts a server under load. */
final class ServerLoadOptions {

    private static final int MOST_ROBOTS = 22;

    @Option(
            names = "--robots",
            paramLabel = "N",
            defaultValue = "22",
            description = "server: robots on the pitch, 2 to 22 (default: 22).")
    private int robots;

    @Option(
            names = "--seconds",
            paramLabel = "T",
            defaultValue = "600",
            description = "server: length of a match, both halves together, in simulated seconds (default: 600).")
    private double seconds;

    @Option(
            names = "--matches",
            paramLabel = "N",
            defaultValue = "1",
            description = "server: matches that one server plays one after the other (default: 1).")
    private int matches;

    @Option(
            names = "--fast",
            description = "server: wait for all robots and run as fast as possible instead of on the clock.")
    private boolean fast;

    @Option(
            names = "--physics",
            paramLabel = "ENGINE",
            description = "server: what computes the motion: exact (ode4j's step) or fast (our own)."
                    + " Usual: ${DEFAULT-VALUE}.")
    private PhysicsEngine physics = PhysicsEngine.STANDARD;

    /**
     * Plays the matches and prints what they cost.
     *
     * @return exit code: 1 when the world has missed a cycle
     * @throws IOException if the server cannot be started
     */
    int measure() throws IOException {
        if (robots < 2 || robots > MOST_ROBOTS) {
            throw new CalledWronglyException("--robots " + robots + ": give a number from 2 to " + MOST_ROBOTS + ".");
        }
        if (!(seconds >= 1) || Double.isInfinite(seconds)) {
            throw new CalledWronglyException("--seconds " + seconds + ": give a length of at least 1 second.");
        }
        if (matches < 1) {
            throw new CalledWronglyException("--matches " + matches + ": give a number of at least 1.");
        }
        LoadSettings load = new LoadSettings(robots, seconds, matches, !fast, physics);
        List<MatchLoadResult> results = new MatchLoad(load, System.out).run();
        System.out.println(MatchLoadResult.TITLE);
        results.forEach(result -> System.out.println(result.toLine()));
        boolean inTime = results.stream().allMatch(result -> result.missedCycles() == 0);
        return inTime ? ExitCode.OK : ExitCode.SOFTWARE;
    }
}
