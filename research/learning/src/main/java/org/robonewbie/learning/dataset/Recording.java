package org.robonewbie.learning.dataset;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.robonewbie.nao.Cycle;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.ThreadRunner;

/**
 * The runs of a data set, recorded in parallel. Each run has its own seed and simulator, so its tables do not depend on the order of the
 * runs.
 *
 * @param set the data set; its complete runs are kept
 * @param runs the number of runs
 * @param robots the number of robots that the program connects
 * @param seconds simulated length of each run
 * @param firstSeed seed of the first run; the seed increases by one for each subsequent run
 * @param variation what differs between the runs
 */
public record Recording(DataSet set, int runs, int robots, double seconds, long firstSeed, RunVariation variation) {

    private static final long MAX_START_SECONDS = 20;

    /** Runs the recorded program. */
    @FunctionalInterface
    public interface Program {

        /**
         * Connects the robots to a simulator and controls them until the end of the run.
         *
         * @param port TCP port of the simulator on this computer
         * @return why the program failed, as a sentence, or an empty string if it succeeded; an empty {@code Optional} if
         *     the user stopped it
         * @throws IOException if it cannot be started
         */
        Optional<String> run(int port) throws IOException;
    }

    /**
     * Records the missing runs. If the program fails in a run, the failure is recorded in the table of runs, and the other runs continue.
     *
     * @param threads the number of parallel runs, at least 1
     * @param program the program
     * @param lines receives a line for each run
     * @throws IOException if the tables cannot be written
     */
    public void run(int threads, Program program, Consumer<String> lines) throws IOException {
        List<Integer> missing = IntStream.rangeClosed(1, runs)
                .filter(run -> !set.has(run))
                .boxed()
                .toList();
        boolean complete = false;
        try (BatchRunner runner = new ThreadRunner(threads);
                BatchProgress progress = BatchProgress.of("runs", runs, runs - missing.size())) {
            runner.run(missing, run -> record(run, program), (run, result) -> {
                if (result.isPresent()) {
                    set.add(result.get());
                    progress.print(lines, line(result.get()));
                    progress.advance(!result.get().failure().isEmpty());
                }
            });
            complete = true;
        } finally {
            if (!complete) {
                discardIncomplete();
            }
        }
    }

    /** Deletes unfinished tables. */
    private void discardIncomplete() throws IOException {
        for (int run = 1; run <= runs; run++) {
            if (!set.has(run)) {
                set.discard(run);
            }
        }
    }

    private Optional<RunResult> record(int run, Program program) throws IOException {
        long seed = firstSeed + run - 1;
        try (RunTables tables = set.begin(run, seed)) {
            Optional<String> failure;
            boolean began;
            boolean over;
            try (Simulator simulator = Simulator.start(settings(seed), Console.silent())) {
                variation.applyTo(simulator.control(), seed);
                simulator.control().addObserver(tables);
                failure = play(simulator, program);
                began = simulator.cycles() > 0;
                over = simulator.cycles() >= Math.round(seconds / Cycle.SECONDS);
            }
            if (failure.isEmpty()) {
                return Optional.empty();
            }
            if (!began && failure.get().isEmpty()) {
                return Optional.of(RunResult.failed(
                        run,
                        seed,
                        "The program did not connect " + robots
                                + (robots == 1 ? " robot." : " robots. Pass their actual number with --robots.")));
            }
            return Optional.of(
                    over || failure.get().isEmpty()
                            ? tables.finish().withFailure(failure.get())
                            : RunResult.failed(run, seed, failure.get()));
        }
    }

    /**
     * Runs the program. The simulator waits for all robots; if some of them do not connect in time, the simulator is closed, which stops
     * the program.
     */
    private static Optional<String> play(Simulator simulator, Program program) throws IOException {
        CompletableFuture<Void> end = new CompletableFuture<>();
        CompletableFuture<Void> deadline = end.orTimeout(MAX_START_SECONDS, TimeUnit.SECONDS)
                .exceptionally(timeout -> {
                    if (simulator.cycles() == 0) {
                        simulator.close();
                    }
                    return null;
                });
        try {
            return program.run(simulator.agentPort());
        } finally {
            end.complete(null);
            deadline.join();
        }
    }

    private SimulatorSettings settings(long seed) {
        return SimulatorSettings.of(variation.settings(seed))
                .withAgentPort(0)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .withAwaitedAgents(robots)
                .withSeconds(seconds);
    }

    private String line(RunResult result) {
        String outcome = result.hasTables() ? result.rows() + " rows" : "failed and is left out. " + result.failure();
        return String.format(Locale.ROOT, "run %d/%d, seed %d: %s", result.run(), runs, result.seed(), outcome);
    }
}
