package org.robonewbie.app.recording;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.robonewbie.learning.dataset.RunResult;
import org.robonewbie.learning.dataset.RunTables;
import org.robonewbie.programs.Program;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.server.Simulator;
import picocli.CommandLine.ExitCode;

/** One run of a data set: a simulator of its own, a program that comes to it, and the tables that watch. */
final class PlayedRun {

    private static final long PATIENCE_SECONDS = 20;

    private final RunOrder order;
    private final int run;
    private final RunTables tables;
    private final Simulator simulator;

    private PlayedRun(RunOrder order, int run, RunTables tables, Simulator simulator) {
        this.order = order;
        this.run = run;
        this.tables = tables;
        this.simulator = simulator;
    }

    static PlayedRun begin(RunOrder order, int run, RunTables tables) throws IOException {
        Simulator simulator = Simulator.start(order.settings(run), Console.silent());
        simulator.control().addObserver(tables);
        return new PlayedRun(order, run, tables, simulator);
    }

    /** Lets the program play; returns its exit code, unless it ends the whole process. */
    int play(Program program) {
        CompletableFuture.delayedExecutor(PATIENCE_SECONDS, TimeUnit.SECONDS).execute(this::giveUpIfNotBegun);
        List<String> options = new ArrayList<>(
                List.of("--host", "127.0.0.1", "--port", Integer.toString(simulator.agentPort()), "--headless"));
        options.addAll(
                order.agentAndOptions().subList(1, order.agentAndOptions().size()));
        return program.run(options);
    }

    /** The world waits for all robots; if some never come, it would wait for ever. */
    private void giveUpIfNotBegun() {
        if (simulator.cycles() == 0) {
            System.err.println(order.agent() + " has not brought " + order.robots() + " robots within "
                    + PATIENCE_SECONDS + " s. Say with --robots how many it brings.");
            simulator.close();
        }
    }

    /**
     * Ends the run.
     *
     * @param exitCode how the program has ended
     * @param why what to tell if it has failed
     * @return what became of the run: its tables are kept unless the program failed before the end
     */
    RunResult end(int exitCode, String why) throws IOException {
        boolean began = simulator.cycles() > 0;
        boolean over = simulator.cycles() >= order.cycles();
        try (tables) {
            simulator.close();
            if (!began || (exitCode != ExitCode.OK && !over)) {
                return RunResult.failed(run, order.seed(run), why);
            }
            RunResult result = tables.finish();
            return exitCode == ExitCode.OK ? result : result.withFailure(why);
        }
    }
}
