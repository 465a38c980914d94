package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.app.studio.SearchConsole;
import org.robonewbie.app.studio.SearchStudio;
import org.robonewbie.app.studio.SearchStudioOptions;
import org.robonewbie.learning.optimise.MotionParametrization;
import org.robonewbie.learning.optimise.Objective;
import org.robonewbie.learning.optimise.Optimisation;
import org.robonewbie.learning.optimise.OptimisationListener;
import org.robonewbie.learning.optimise.OptimisationPlan;
import org.robonewbie.learning.optimise.OptimisationResult;
import org.robonewbie.learning.optimise.OtherSide;
import org.robonewbie.learning.optimise.Parametrization;
import org.robonewbie.learning.optimise.WalkParametrization;
import org.robonewbie.learning.search.CovarianceMatrixAdaptation;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Command that optimises a motion, the walk engine or an agent by running trials in the simulator. */
@Command(
        name = "optimise",
        description = {
            "Optimise the numbers of a motion, the walk engine or an agent through trials in the simulator (CMA-ES).",
            "",
            "Objectives: distance-walked, walk-speed, energy, stability, standing-time, get-up-time, kick-distance,",
            "time-to-score, or a custom class that implements Measure.",
            "The same seed and options give the same result on any number of threads and on a cluster. --resume continues an",
            "interrupted run. A page of the studio shows the progress, and the program exits when the page is closed; --headless",
            "opens no page. Exit code 1: no improvement was found."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie optimise kick-right --objective kick-distance",
            "  robonewbie optimise my-walk.txt --objective walk-speed --generations 60 --seed 3",
            "  robonewbie optimise my-walk.txt --objective walk-speed --generations 60 --seed 3 --resume",
            "  robonewbie optimise walk-engine --objective stability --threads 1 --headless",
            "  robonewbie optimise --agent Walker.java --objective distance-walked --seconds 10",
            "",
            "On a cluster: see docs/cluster.md."
        })
final class OptimiseCommand implements Callable<Integer> {

    private static final double STEP_OF_MOTIONS = 0.05;
    private static final double STEP_OF_AGENTS = 0.5;

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            arity = "0..1",
            paramLabel = "MOTION",
            description = "What to optimise: a motion of the library, a motion file, or walk-engine.")
    private String name = "";

    @Mixin
    final OptimisedAgent agent = new OptimisedAgent();

    @Option(names = "--objective", paramLabel = "NAME", description = "Measure to optimise.")
    private String objective = "";

    @Option(
            names = "--generations",
            paramLabel = "N",
            defaultValue = "30",
            description = "Number of generations (default: 30).")
    private int generations;

    @Option(
            names = "--population",
            paramLabel = "N",
            description = "Candidates per generation (default: 4 + 3 ln(n) for n numbers).")
    private Optional<Integer> population = Optional.empty();

    @Option(
            names = "--plain",
            description = "Use CMA-ES without negative weights or restarts, as for the library's motions.")
    private boolean plain;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "Seed for candidates and trials (default: 1).")
    private long seed;

    @Option(
            names = "--seeds",
            paramLabel = "N",
            defaultValue = "4",
            description = "Trials per candidate, each with different disturbances (default: 4).")
    private int trials;

    @Option(
            names = "--step",
            paramLabel = "X",
            description =
                    "Initial step size: 1 is 5 degrees and 60 ms in each keyframe (default: 0.05), or a quarter of the range"
                            + " of each number of an agent (default: 0.5).")
    private Optional<Double> step = Optional.empty();

    @Mixin
    private final EngineOption where = new EngineOption();

    @Option(
            names = "--output",
            paramLabel = "FILE",
            description = "Result file (default: NAME-optimised.txt in this folder).")
    private Optional<Path> output = Optional.empty();

    @Option(
            names = "--both-sides",
            description = "Also write the mirrored motion for the other side, next to the result file.")
    private boolean bothSides;

    @Option(names = "--resume", description = "Resume an interrupted run from its file OUTPUT.checkpoint.")
    private boolean resume;

    @Mixin
    final SearchStudioOptions studio = new SearchStudioOptions();

    @Override
    public Integer call() throws IOException, InterruptedException {
        try {
            return optimise();
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        }
    }

    private int optimise() throws IOException, InterruptedException {
        if (!where.isLocal() && agent.isSourceFile()) {
            throw new CalledWronglyException(
                    "A cluster cannot run a source file. Compile it, pass the name of its class to --agent, and send"
                            + " its jar to the workers (docs/cluster.md).");
        }
        if (agent.isGiven() != name.isEmpty()) {
            throw new CalledWronglyException(
                    "Name exactly one subject to optimise: a motion, walk-engine, or --agent CLASS.");
        }
        if (objective.isEmpty()) {
            throw new CalledWronglyException("Name the measure for optimising " + plainName()
                    + ": --objective NAME. Available: " + Objective.labels() + ".");
        }
        Objective wanted = agent.objective(objective);
        Parametrization subject = subject(wanted);
        Path file = output.orElse(agent.isGiven() ? agent.file() : Path.of(plainName() + "-optimised.txt"));
        if (bothSides) {
            OtherSide.of(file);
        }
        int candidates = population.orElseGet(() -> CovarianceMatrixAdaptation.defaultPopulation(subject.dimension()));
        var plan = new OptimisationPlan(seed, generations, candidates, trials, firstStep(), where.threads(), plain);
        Optimisation optimisation = where.isLocal()
                ? new Optimisation(subject, wanted, plan, file)
                : Optimisation.on(where.runner(), subject, wanted, plan, file);
        System.out.printf(
                Locale.ROOT,
                "%s: %d numbers, %d generations of %d candidates with %d trials each, on %s%n",
                subject.name(),
                subject.dimension(),
                generations,
                candidates,
                trials,
                where.isLocal() ? where.threads() + " threads" : "a cluster");
        OptimisationResult result = run(optimisation, subject, wanted, plan, file);
        return result.isBetter() ? ExitCode.OK : ExitCode.SOFTWARE;
    }

    private OptimisationResult run(
            Optimisation optimisation, Parametrization subject, Objective wanted, OptimisationPlan plan, Path file)
            throws IOException, InterruptedException {
        OptimisationListener console = new SearchConsole(System.out, wanted.unit(), file);
        if (studio.isHeadless()) {
            return search(optimisation, subject, console, file);
        }
        try (SearchStudio pages = SearchStudio.open(studio, subject, wanted, plan, optimisation, file)) {
            System.out.println("Studio: " + pages.invitation());
            pages.showBrowser();
            OptimisationResult result = search(optimisation, subject, pages.and(console), file);
            pages.awaitUnwatched();
            return result;
        }
    }

    private OptimisationResult search(
            Optimisation optimisation, Parametrization subject, OptimisationListener listener, Path file)
            throws IOException {
        if (agent.isGiven()) {
            reportErrors(subject);
        }
        OptimisationResult result = agent.isGiven()
                ? SilentPrograms.entirely(() -> optimisation.run(resume, listener))
                : optimisation.run(resume, listener);
        if (result.isBetter() && bothSides) {
            OtherSide.write(file);
        }
        return result;
    }

    /** Runs an agent once with its output shown, because the output of the following trials is suppressed. */
    private void reportErrors(Parametrization subject) throws IOException {
        SilentPrograms.complaining(() -> subject.evaluate(new double[subject.dimension()], seed));
    }

    private double firstStep() {
        return step.orElse(agent.isGiven() ? STEP_OF_AGENTS : STEP_OF_MOTIONS);
    }

    private String plainName() {
        if (agent.isGiven()) {
            return agent.simpleName();
        }
        return String.valueOf(Path.of(name).getFileName()).replaceFirst("\\.txt$", "");
    }

    private Parametrization subject(Objective wanted) throws IOException {
        if (agent.isGiven()) {
            return agent.subject(wanted);
        }
        if (name.equals(WalkParametrization.NAME)) {
            return new WalkParametrization(wanted);
        }
        return new MotionParametrization(name.replace('\\', '/'), motionFile(), wanted);
    }

    private MotionFile motionFile() throws IOException {
        Path path = Path.of(name);
        if (!name.endsWith(".txt")) {
            return ShippedMotions.file(name);
        }
        if (!Files.isRegularFile(path)) {
            throw new CalledWronglyException("There is no motion file " + path + ".");
        }
        MotionFile file = MotionFiles.load(path);
        if (!file.errors().isEmpty()) {
            throw new CalledWronglyException(
                    path + " cannot be read: " + file.errors().get(0));
        }
        return file;
    }
}
