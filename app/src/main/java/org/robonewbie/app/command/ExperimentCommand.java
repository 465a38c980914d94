package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.learning.series.Experiment;
import org.robonewbie.learning.series.ExperimentPlan;
import org.robonewbie.learning.series.ExperimentRun;
import org.robonewbie.learning.series.ResultTable;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ProgramFinder;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Command that runs an experiment, a series of trials, and writes a table of its results. */
@Command(
        name = "experiment",
        description = {
            "Run the trials of an experiment and write a table of the results.",
            "",
            "A plan is a text file such as:",
            "  experiment=org.robonewbie.learning.series.PushExperiment",
            "  trials=1000",
            "  seed=1",
            "  newtons=20,40,60",
            "All names except the first three are parameters; the trials cycle through all combinations of their values.",
            "The table does not depend on the engine or the number of threads. Each result is saved immediately next to the",
            "table. To resume an interrupted run, run the same command again."
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

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(paramLabel = "PLAN", description = "File with the plan of the experiment.")
    private Path planFile = Path.of("");

    @Mixin
    private final EngineOption where = new EngineOption();

    @Option(
            names = "--output",
            paramLabel = "FILE",
            description = "Table to write, .csv or .json (default: the name of the plan with .csv, in this folder).")
    private Optional<Path> output = Optional.empty();

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
        try (BatchRunner runner = where.runner()) {
            return run(ExperimentPlan.read(planFile), runner);
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        } catch (IllegalStateException failed) {
            System.err.println(failed.getMessage());
            return ExitCode.SOFTWARE;
        }
    }

    /** Runs the missing trials; the journal beside the table is deleted when the table is complete. */
    private int run(ExperimentPlan plan, BatchRunner runner) throws IOException {
        Path table = output.orElseGet(this::namedAfterThePlan);
        if (Files.exists(table) && Files.isSameFile(table, planFile)) {
            throw new CalledWronglyException("The table would replace the plan. Choose another file with --output.");
        }
        Experiment experiment = Experiment.of(plan.experiment());
        experiment.parameters().ifPresent(plan::requireKnown);
        Path journal = table.resolveSibling(table.getFileName() + ".trials");
        try (ExperimentRun run = ExperimentRun.open(journal, plan)) {
            int missing = run.missing().size();
            int done = plan.trials() - missing;
            if (done > 0) {
                System.err.println(done + " trials are already done; " + missing + " are left.");
            }
            try (BatchProgress progress = BatchProgress.of("trials", plan.trials(), done)) {
                run.run(runner, progress);
            }
            ResultTable results = run.table(experiment.columns());
            results.write(table);
            System.out.println("Wrote " + results.trials().size() + " trials to " + table + ".");
            if (run.failures().isEmpty()) {
                run.delete();
                return ExitCode.OK;
            }
            run.failures().forEach(System.err::println);
            System.err.println(run.failures().size()
                    + " trials failed (see above). To retry them, run the command again; the other results are kept.");
            return ExitCode.SOFTWARE;
        }
    }

    private Path namedAfterThePlan() {
        return Path.of(planFile.getFileName().toString().replaceFirst("\\.[^.]*$", "") + ".csv");
    }
}
