package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.robonewbie.learning.optimise.Generation.Pace;
import org.robonewbie.learning.optimise.Generation.Score;
import org.robonewbie.learning.search.AskAndTell;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.Job;
import org.robonewbie.trial.batch.ThreadRunner;

/**
 * Optimisation of a parametrization for an objective by CMA-ES. Each candidate is evaluated with several seeds. At the end, the initial
 * values and the result are compared in trials with seeds that the search has not used.
 *
 * <pre>{@code
 * Objective distance = Objective.named("kick-distance", classes);
 * var optimisation = new Optimisation(new MotionParametrization("kick-right", file, distance), distance, plan, output);
 * OptimisationResult result = optimisation.run(false, System.out::println);
 * }</pre>
 */
public final class Optimisation {

    private static final int COMPARISON_TRIALS = 20;
    private static final long FIRST_COMPARISON_SEED = 700_000_000;
    private static final long SEEDS_PER_RUN = 1_000_000;
    private static final int GENERATIONS_PER_SEEDS = 2;
    private static final double MIN_SCALE = 0.01;

    private final Parametrization subject;
    private final Objective objective;
    private final OptimisationPlan plan;
    private final Path output;
    private final Supplier<BatchRunner> runners;
    private final Job<CandidateTrial, Evaluation> job;

    /**
     * Creates an optimisation whose trials run on threads of this process.
     *
     * @param subject the parametrization to optimise
     * @param objective the objective
     * @param plan the settings of the search
     * @param output file of the result; the checkpoint is written beside it
     */
    public Optimisation(Parametrization subject, Objective objective, OptimisationPlan plan, Path output) {
        this(
                subject,
                objective,
                plan,
                output,
                () -> new ThreadRunner(plan.threads()),
                trial -> subject.evaluate(trial.candidate, trial.seed));
    }

    /**
     * Creates an optimisation whose trials run on a cluster. The result does not depend on the runner.
     *
     * @param runner runs the trials and is closed at the end
     * @param subject the parametrization to optimise
     * @param objective the objective
     * @param plan the settings of the search
     * @param output file of the result; the checkpoint is written beside it
     * @return the optimisation
     * @throws IllegalArgumentException if the parametrization cannot be sent to other computers
     */
    public static Optimisation on(
            BatchRunner runner, Parametrization subject, Objective objective, OptimisationPlan plan, Path output) {
        return new Optimisation(subject, objective, plan, output, () -> runner, job(subject.recipe()));
    }

    private static Job<CandidateTrial, Evaluation> job(Parametrization.Recipe recipe) {
        return trial ->
                recipe.create(Thread.currentThread().getContextClassLoader()).evaluate(trial.candidate, trial.seed);
    }

    private Optimisation(
            Parametrization subject,
            Objective objective,
            OptimisationPlan plan,
            Path output,
            Supplier<BatchRunner> runners,
            Job<CandidateTrial, Evaluation> job) {
        this.subject = subject;
        this.objective = objective;
        this.plan = plan;
        this.output = output.toAbsolutePath();
        this.runners = runners;
        this.job = job;
    }

    @SuppressWarnings("ArrayRecordComponent")
    private record CandidateTrial(double[] candidate, long seed) implements Serializable {}

    /**
     * Runs the search, compares its result with the initial values, and writes the result if it is better.
     *
     * @param resume whether to resume an interrupted run, which has the same result as an uninterrupted one
     * @param listener called for each generation, including those completed before the interruption
     * @return the comparison of the initial values and the result
     * @throws IOException if a file cannot be read or written
     */
    public OptimisationResult run(boolean resume, OptimisationListener listener) throws IOException {
        try (Checkpoint checkpoint = resume
                        ? Checkpoint.resume(checkpointFile(), question())
                        : Checkpoint.begin(checkpointFile(), question());
                BatchRunner runner = runners.get()) {
            Evaluation before = compared(runner, new double[subject.dimension()]);
            listener.begins(before);
            double scale = Math.max(MIN_SCALE, Math.abs(before.value()));
            double[] found = search(runner, checkpoint, scale, listener);
            Evaluation after = compared(runner, found);
            OptimisationResult result =
                    new OptimisationResult(objective, before, after, COMPARISON_TRIALS, subject.advice(found));
            if (result.isBetter()) {
                subject.save(found, facts(result), output);
            }
            Files.deleteIfExists(fileSoFar());
            listener.ends(result);
            return result;
        }
    }

    /** {@return the checkpoint file, beside the output} */
    public Path checkpointFile() {
        return output.resolveSibling(output.getFileName() + ".checkpoint");
    }

    /**
     * {@return the file with the current mean of the search, beside the output; it exists from the first generation until
     * the end}
     */
    public Path fileSoFar() {
        String name = String.valueOf(output.getFileName());
        int dot = name.lastIndexOf('.');
        String ending = dot > 0 ? name.substring(dot) : "";
        return output.resolveSibling(name.substring(0, name.length() - ending.length()) + "-so-far" + ending);
    }

    private double[] search(BatchRunner runner, Checkpoint checkpoint, double scale, OptimisationListener listener)
            throws IOException {
        AskAndTell search = plan.search(subject.dimension());
        List<Checkpoint.Line> known = checkpoint.generations();
        long begin = System.nanoTime();
        for (int i = 0; i < plan.generations(); i++) {
            List<double[]> candidates = search.ask();
            if (i < known.size()) {
                search.tell(known.get(i).costs());
                listener.reached(generation(i, known.get(i).score(), search, Pace.UNKNOWN));
            } else {
                List<List<Evaluation>> evaluations = evaluations(runner, candidates, firstSeed(i), plan.trials());
                double sign = objective.isLargerBetter() ? -1 : 1;
                double[] costs = evaluations.stream()
                        .mapToDouble(trials -> Evaluation.cost(trials, sign, scale))
                        .toArray();
                Score score = score(evaluations, costs);
                search.tell(costs);
                checkpoint.add(costs, score);
                subject.save(search.mean(), Map.of("so far", "generation " + (i + 1)), fileSoFar());
                double seconds = (System.nanoTime() - begin) / 1e9 / (i + 1 - known.size());
                Pace pace = new Pace(costs.length * plan.trials() / seconds, seconds * (plan.generations() - i - 1));
                listener.reached(generation(i, score, search, pace));
            }
        }
        return search.mean();
    }

    private Generation generation(int index, Score score, AskAndTell search, Pace pace) {
        return new Generation(index + 1, plan.generations(), score, SearchDistribution.of(search), pace);
    }

    private static Score score(List<List<Evaluation>> evaluations, double[] costs) {
        List<Evaluation> means = evaluations.stream().map(Evaluation::mean).toList();
        int best = IntStream.range(0, costs.length)
                .reduce((a, b) -> costs[b] < costs[a] ? b : a)
                .orElseThrow();
        Evaluation all = Evaluation.mean(means);
        return new Score(means.get(best).value(), all.value(), all.success());
    }

    private List<List<Evaluation>> evaluations(
            BatchRunner runner, List<double[]> candidates, long firstSeed, int trials) throws IOException {
        List<CandidateTrial> all = candidates.stream()
                .flatMap(candidate -> LongStream.range(firstSeed, firstSeed + trials)
                        .mapToObj(seed -> new CandidateTrial(candidate, seed)))
                .toList();
        List<Evaluation> evaluations = runner.run(all, job);
        return IntStream.range(0, candidates.size())
                .mapToObj(i -> evaluations.subList(i * trials, (i + 1) * trials))
                .toList();
    }

    private Evaluation compared(BatchRunner runner, double[] coordinates) throws IOException {
        return Evaluation.mean(evaluations(runner, List.of(coordinates), FIRST_COMPARISON_SEED, COMPARISON_TRIALS)
                .get(0));
    }

    private long firstSeed(int generation) {
        return plan.seed() * SEEDS_PER_RUN + generation / GENERATIONS_PER_SEEDS * 1000L;
    }

    /** Returns the settings that identify the search: all those that determine its course, except the number of generations. */
    private String question() {
        return "optimise " + subject.commandLine() + " " + subject.fingerprint() + " --objective " + objective.label()
                + " " + plan.options(false);
    }

    private Map<String, String> facts(OptimisationResult result) {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put(
                "made by",
                "robonewbie optimise " + subject.commandLine() + " --objective " + objective.label() + " "
                        + plan.options(true));
        facts.put("before", result.words(result.before()));
        facts.put("after", result.words(result.after()));
        return facts;
    }
}
