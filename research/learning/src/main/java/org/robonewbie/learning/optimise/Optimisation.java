package org.robonewbie.learning.optimise;

import java.io.IOException;
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
import org.robonewbie.learning.series.ExperimentEngine;

/**
 * Improves a subject with respect to an objective: candidates around the present state are tried under several circumstances,
 * and the distribution from which they are drawn moves towards the better ones. At the end start and result are compared in
 * trials that the search has never seen.
 *
 * <pre>{@code
 * Objective far = Objective.named("kick-distance", classes);
 * var optimisation = new Optimisation(new MotionSubject("kick-right", file, far), far, plan, output);
 * OptimisationResult result = optimisation.run(false, System.out::println);
 * }</pre>
 */
public final class Optimisation {

    private static final int TRIALS_OF_COMPARISON = 20;
    private static final long SEEDS_OF_COMPARISON = 700_000_000;
    private static final long SEEDS_FOR_EACH_RUN = 1_000_000;
    private static final int GENERATIONS_WITH_SAME_TRIALS = 2;
    private static final double LEAST_SCALE = 0.01;

    private final Subject subject;
    private final Objective objective;
    private final OptimisationPlan plan;
    private final Path output;
    private final Supplier<Evaluator> evaluators;

    /**
     * Prepares an optimisation whose trials are carried out by threads of this program.
     *
     * @param subject what is to be improved
     * @param objective what is measured
     * @param plan the plan of the search
     * @param output where the result is written; the checkpoint lies next to it
     */
    public Optimisation(Subject subject, Objective objective, OptimisationPlan plan, Path output) {
        this(subject, objective, plan, output, () -> new Workers(subject, plan.threads()));
    }

    /**
     * Prepares an optimisation whose trials an engine carries out, which is closed at the end. The result is the same.
     *
     * @param engine carries out the trials
     * @param master where, in the engine's own notation; empty for its usual place
     * @param subject what is to be improved
     * @param objective what is measured
     * @param plan the plan of the search
     * @param output where the result is written; the checkpoint lies next to it
     * @return the optimisation
     */
    public static Optimisation on(
            ExperimentEngine engine,
            String master,
            Subject subject,
            Objective objective,
            OptimisationPlan plan,
            Path output) {
        return new Optimisation(subject, objective, plan, output, () -> new EngineEvaluator(subject, engine, master));
    }

    private Optimisation(
            Subject subject, Objective objective, OptimisationPlan plan, Path output, Supplier<Evaluator> evaluators) {
        this.subject = subject;
        this.objective = objective;
        this.plan = plan;
        this.output = output.toAbsolutePath();
        this.evaluators = evaluators;
    }

    /**
     * Searches, compares, and writes the result if it is better than the start.
     *
     * @param resume whether to continue an interrupted run; the result is that of a run that was never interrupted
     * @param listener called for each generation, including those from before the interruption
     * @return how much better it has become
     * @throws IOException if a file cannot be read or written
     */
    public OptimisationResult run(boolean resume, OptimisationListener listener) throws IOException {
        Checkpoint checkpoint = resume
                ? Checkpoint.resume(checkpointFile(), question())
                : Checkpoint.begin(checkpointFile(), question());
        try (Evaluator workers = evaluators.get()) {
            Evaluation before = compared(workers, new double[subject.dimension()]);
            listener.begins(before);
            double[] found = search(workers, checkpoint, scale(before), listener);
            Evaluation after = compared(workers, found);
            OptimisationResult result =
                    new OptimisationResult(objective, before, after, TRIALS_OF_COMPARISON, subject.advice(found));
            if (result.isBetter()) {
                subject.save(found, facts(result), output);
            }
            Files.deleteIfExists(fileSoFar());
            listener.ends(result);
            return result;
        }
    }

    /** {@return the checkpoint file, next to the output} */
    public Path checkpointFile() {
        return output.resolveSibling(output.getFileName() + ".checkpoint");
    }

    /**
     * {@return the file that holds the present state of the search, next to the output, from the first generation to the end}
     */
    public Path fileSoFar() {
        String name = String.valueOf(output.getFileName());
        int dot = name.lastIndexOf('.');
        String ending = dot > 0 ? name.substring(dot) : "";
        return output.resolveSibling(name.substring(0, name.length() - ending.length()) + "-so-far" + ending);
    }

    private double[] search(Evaluator workers, Checkpoint checkpoint, double scale, OptimisationListener listener)
            throws IOException {
        AskAndTell cloud = plan.search(subject.dimension());
        List<Checkpoint.Line> known = checkpoint.generations();
        long begin = System.nanoTime();
        for (int i = 0; i < plan.generations(); i++) {
            List<double[]> candidates = cloud.ask();
            if (i < known.size()) {
                cloud.tell(known.get(i).costs());
                listener.reached(generation(i, known.get(i).score(), cloud, Pace.UNKNOWN));
            } else {
                List<List<Evaluation>> evaluations = evaluations(workers, candidates, firstSeed(i));
                double[] costs = evaluations.stream()
                        .mapToDouble(trials -> Evaluation.cost(trials, sign(), scale))
                        .toArray();
                Score score = score(evaluations, costs);
                cloud.tell(costs);
                checkpoint.add(costs, score);
                subject.save(cloud.mean(), Map.of("so far", "generation " + (i + 1)), fileSoFar());
                double seconds = (System.nanoTime() - begin) / 1e9 / (i + 1 - known.size());
                Pace pace = new Pace(costs.length * plan.trials() / seconds, seconds * (plan.generations() - i - 1));
                listener.reached(generation(i, score, cloud, pace));
            }
        }
        return cloud.mean();
    }

    private Generation generation(int index, Score score, AskAndTell cloud, Pace pace) {
        return new Generation(index + 1, plan.generations(), score, SearchDistribution.of(cloud), pace);
    }

    private static Score score(List<List<Evaluation>> evaluations, double[] costs) {
        List<Evaluation> means = evaluations.stream().map(Evaluation::mean).toList();
        int best = IntStream.range(0, costs.length)
                .reduce((a, b) -> costs[b] < costs[a] ? b : a)
                .orElseThrow();
        Evaluation all = Evaluation.mean(means);
        return new Score(means.get(best).value(), all.value(), all.success());
    }

    private List<List<Evaluation>> evaluations(Evaluator workers, List<double[]> candidates, long firstSeed) {
        List<Evaluation> all = workers.all(candidates, seeds(firstSeed, plan.trials()));
        return IntStream.range(0, candidates.size())
                .mapToObj(i -> all.subList(i * plan.trials(), (i + 1) * plan.trials()))
                .toList();
    }

    private Evaluation compared(Evaluator workers, double[] coordinates) {
        return Evaluation.mean(workers.all(List.of(coordinates), seeds(SEEDS_OF_COMPARISON, TRIALS_OF_COMPARISON)));
    }

    private static List<Long> seeds(long first, int count) {
        return LongStream.range(first, first + count).boxed().toList();
    }

    private long firstSeed(int generation) {
        return plan.seed() * SEEDS_FOR_EACH_RUN + generation / GENERATIONS_WITH_SAME_TRIALS * 1000L;
    }

    private static double scale(Evaluation before) {
        return Math.max(LEAST_SCALE, Math.abs(before.value()));
    }

    private double sign() {
        return objective.isLargerBetter() ? -1 : 1;
    }

    /** Everything that the way of the search depends on, but not how long it is. */
    private String question() {
        return "optimise " + subject.words() + " " + subject.fingerprint() + " --objective " + objective.label() + " "
                + plan.options(false);
    }

    private Map<String, String> facts(OptimisationResult result) {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put(
                "made by",
                "robonewbie optimise " + subject.words() + " --objective " + objective.label() + " "
                        + plan.options(true));
        facts.put("before", result.words(result.before()));
        facts.put("after", result.words(result.after()));
        return facts;
    }
}
