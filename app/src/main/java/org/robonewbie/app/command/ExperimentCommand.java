package org.robonewbie.app.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntConsumer;
import org.robonewbie.learning.series.Experiment;
import org.robonewbie.learning.series.ExperimentEngine;
import org.robonewbie.learning.series.ExperimentPlan;
import org.robonewbie.learning.series.PlannedTrial;
import org.robonewbie.learning.series.ResultTable;
import org.robonewbie.learning.series.TrialJournal;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ProgramFinder;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Carries out a series of trials and writes a table. */
@Command(
        name = "experiment",
        description = {
            "Carry out many trials of an experiment and write a table.",
            "",
            "A plan is a text file such as:",
            "  experiment=org.robonewbie.learning.series.PushExperiment",
            "  trials=1000",
            "  seed=1",
            "  newtons=20,40,60",
            "Each name but the first three is a parameter; all combinations of values are tried in turn.",
            "The table is the same for any engine and any number of threads. Each result is kept at once in a file beside it:",
            "after a kill or on a full disk the same command goes on where it was."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie experiment push.plan --output push.csv",
            "  robonewbie experiment my.plan --class-path target/classes --output my.json",
            "",
            "On a cluster: see docs/cluster.md."
        })
final class ExperimentCommand implements Callable<Integer> {

    private static final long NANOSECONDS_BETWEEN_LINES = 2_000_000_000L;

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(paramLabel = "PLAN", description = "A file that says what to do.")
    private Path planFile = Path.of("");

    @Mixin
    private final EngineOption where = new EngineOption();

    @Option(
            names = "--output",
            paramLabel = "FILE",
            defaultValue = "experiment.csv",
            description = "Table to write, .csv or .json (default: experiment.csv).")
    private Path output = Path.of("experiment.csv");

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    @Override
    public Integer call() throws IOException {
        if (!Files.isRegularFile(planFile)) {
            throw new CalledWronglyException(
                    "There is no plan \"" + planFile + "\". See robonewbie experiment --help.");
        }
        List<Path> folders = classPath.folders();
        Thread.currentThread().setContextClassLoader(ProgramFinder.loaderOf(folders));
        try (ExperimentEngine engine = where.engine()) {
            return run(ExperimentPlan.read(planFile), engine);
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        } catch (IllegalStateException failed) {
            System.err.println(failed.getMessage());
            return ExitCode.SOFTWARE;
        } catch (UncheckedIOException full) {
            throw Objects.requireNonNull(full.getCause());
        }
    }

    /** Keeps each result in a file beside the table until that is written, so that nothing is done twice. */
    private int run(ExperimentPlan plan, ExperimentEngine chosen) throws IOException {
        Experiment experiment = Experiment.of(plan.experiment());
        experiment.parameters().ifPresent(plan::refuseOthersThan);
        try (TrialJournal journal = TrialJournal.open(output.resolveSibling(output.getFileName() + ".trials"), plan)) {
            List<PlannedTrial> missing = journal.missing();
            if (journal.done() > 0) {
                System.err.println(
                        journal.done() + " trials are done already and kept, " + missing.size() + " are left.");
            }
            chosen.run(plan.experiment(), missing, where.master(), progress(missing.size()), journal);
            ResultTable table = journal.table(experiment.columns());
            table.write(output);
            System.out.println("Wrote " + table.trials().size() + " trials to " + output + ".");
            if (journal.failures().isEmpty()) {
                journal.delete();
                return ExitCode.OK;
            }
            journal.failures().forEach(System.err::println);
            System.err.println(journal.failures().size()
                    + " trials failed, see above. The others are kept; the same command tries again what is missing.");
            return ExitCode.SOFTWARE;
        }
    }

    private static IntConsumer progress(int all) {
        long start = System.nanoTime();
        AtomicLong lastLine = new AtomicLong(start);
        return done -> {
            long now = System.nanoTime();
            long last = lastLine.get();
            if (done == all || (now - last > NANOSECONDS_BETWEEN_LINES && lastLine.compareAndSet(last, now))) {
                double seconds = (now - start) / 1e9;
                System.err.printf(
                        Locale.ROOT,
                        "%d of %d trials, %.1f per second, %.0f s left%n",
                        done,
                        all,
                        done / seconds,
                        seconds / done * (all - done));
            }
        };
    }
}
