package org.robonewbie.learning.policy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.Journal;

/**
 * Direct policy search by an {@link EvolutionStrategy}. Each generation saves the current policy, a row of the learning curve (CSV) and a
 * checkpoint. From the checkpoint, an interrupted search resumes with the same result.
 *
 * <pre>{@code
 * PolicySearch search = new PolicySearch(model, new EvolutionStrategy(1, 16, 0.05, 0.01), Path.of("Stand.policy"));
 * Policy learned = search.run(500, Optional.empty(), System.out::println);
 * }</pre>
 *
 * @param model the policies to search
 * @param strategy the search method
 * @param output file of the policy; the learning curve and the checkpoint are written beside it
 */
public record PolicySearch(PolicyModel model, EvolutionStrategy strategy, Path output) {

    private static final long MAX_SEED = 1_000_000_000;
    private static final long EPISODES_PER_SEED = 1_000_000;

    /** {@return the file of the learning curve, a CSV file beside the policy} */
    public Path curve() {
        return beside(".csv");
    }

    /** {@return the file of the checkpoint, beside the policy} */
    public Path checkpoint() {
        return beside(".checkpoint");
    }

    private Path beside(String ending) {
        return output.resolveSibling(output.getFileName() + ending);
    }

    /**
     * Evaluates a policy in episodes with seeds that no search uses.
     *
     * @param model the task
     * @param episodes the number of episodes
     * @param policy the policy that acts in the episodes
     * @return the statistics of the episodes
     * @throws IOException if an episode cannot be played
     * @throws IllegalArgumentException if the policy was learned for another task
     */
    public static RolloutStatistics evaluate(PolicyModel model, int episodes, Policy policy) throws IOException {
        return evaluate(model, episodes, 1, policy);
    }

    /**
     * Evaluates a policy in one of many disjoint sets of episodes, none of which a search uses.
     *
     * @param model the task
     * @param episodes the number of episodes, at most 1,000,000
     * @param seed chooses the episodes, 1 to 1,000,000,000; {@link #evaluate(PolicyModel, int, Policy)} uses 1
     * @param policy the policy that acts in the episodes
     * @return the statistics of the episodes
     * @throws IOException if an episode cannot be played
     * @throws IllegalArgumentException if the policy was learned for another task, or the seed is out of range
     */
    public static RolloutStatistics evaluate(PolicyModel model, int episodes, long seed, Policy policy)
            throws IOException {
        if (seed < 1 || seed > MAX_SEED) {
            throw new IllegalArgumentException(
                    "The seed of an evaluation must be between 1 and " + MAX_SEED + ", not " + seed + ".");
        }
        long first = -1 - (seed - 1) * EPISODES_PER_SEED;
        try (RolloutWorkers workers = new RolloutWorkers(model)) {
            return workers.play(episodes, i -> policy, i -> first - i);
        }
    }

    /**
     * Searches until a number of generations is complete, starting from the checkpoint if there is one, and shows the
     * progress on standard error.
     *
     * @param generations the number of generations, including those before an interruption
     * @param start the policy from which a new search starts; empty for an untrained one
     * @param output receives a line after each generation
     * @return the learned policy
     * @throws IOException if a file cannot be read or written
     * @throws IllegalArgumentException if the checkpoint belongs to another search or is damaged
     */
    public Policy run(int generations, Optional<Policy> start, Consumer<String> output) throws IOException {
        try (Journal journal = Journal.open(checkpoint(), question());
                RolloutWorkers workers = new RolloutWorkers(model)) {
            boolean resumes = !journal.lines().isEmpty();
            List<String> history =
                    resumes ? history() : start.map(Policy::about).orElse(List.of());
            EvolutionStrategy.State state = resumes ? replayed(journal.lines()) : begin(start);
            if (!resumes) {
                journal.add(line(state.mean()));
            }
            beginCurve(state.generation());
            try (BatchProgress progress = BatchProgress.of("generations", generations, state.generation())) {
                while (state.generation() < generations) {
                    RolloutStatistics result = generation(workers, state);
                    double[] returns = result.rollouts().stream()
                            .mapToDouble(Rollout::reward)
                            .toArray();
                    state = strategy.tell(state, returns);
                    save(state, history, result);
                    journal.add(line(returns));
                    progress.advance(false);
                    progress.print(output, String.format(Locale.ROOT, "generation %d: %s", state.generation(), result));
                }
            }
            return policy(state, history);
        }
    }

    private EvolutionStrategy.State begin(Optional<Policy> start) {
        double[] mean = start.map(model::initial).orElseGet(() -> model.initial(strategy.seed()));
        return EvolutionStrategy.State.begin(mean, model.scale());
    }

    /**
     * Returns the history of the policy from which an interrupted search started: the history in the output file without
     * its last line, which the search itself has added.
     */
    private List<String> history() {
        if (!Files.exists(output)) {
            return List.of();
        }
        List<String> all = PolicyFile.read(output).about();
        return all.subList(0, Math.max(0, all.size() - 1));
    }

    private RolloutStatistics generation(RolloutWorkers workers, EvolutionStrategy.State state) throws IOException {
        List<double[]> candidates = strategy.ask(state);
        return workers.play(
                candidates.size(),
                i -> model.policy(List.of(), candidates.get(i)),
                i -> strategy.seedOfTrial(state, i));
    }

    /**
     * Removes from the learning curve any row that is newer than the checkpoint; an interrupted search may have written
     * one.
     */
    private void beginCurve(int generations) throws IOException {
        Stream<String> lines = generations == 0 ? Stream.empty() : Files.readAllLines(curve()).stream();
        AtomicFile.write(
                curve(),
                Stream.concat(
                                Stream.of("generation," + RolloutStatistics.COLUMNS),
                                lines.skip(1).limit(generations))
                        .collect(Collectors.joining("\n", "", "\n")));
    }

    private void save(EvolutionStrategy.State state, List<String> history, RolloutStatistics result)
            throws IOException {
        String line = state.generation() + "," + result.row() + "\n";
        Files.writeString(curve(), line, StandardCharsets.UTF_8, StandardOpenOption.APPEND);
        AtomicFile.write(output, PolicyText.format(policy(state, history)));
    }

    private Policy policy(EvolutionStrategy.State state, List<String> history) {
        String last = "learned by: robonewbie learn " + question() + " --generations " + state.generation();
        return model.policy(Stream.concat(history.stream(), Stream.of(last)).toList(), state.mean());
    }

    /** Returns the settings that identify the search: all those that determine its result, except the number of generations. */
    private String question() {
        return model.task() + " " + strategy.commandLine() + model.commandLine();
    }

    /**
     * Restores the state by replaying a checkpoint. Its first line is the initial mean; each other line contains the
     * returns of one generation.
     */
    private EvolutionStrategy.State replayed(List<String> lines) {
        try {
            EvolutionStrategy.State state = EvolutionStrategy.State.begin(numbers(lines.get(0)), model.scale());
            for (String returns : lines.subList(1, lines.size())) {
                state = strategy.tell(state, numbers(returns));
            }
            return state;
        } catch (IndexOutOfBoundsException | NumberFormatException damaged) {
            throw new IllegalArgumentException(checkpoint() + " is damaged. Delete it to start a new search.", damaged);
        }
    }

    private static String line(double... numbers) {
        return Arrays.stream(numbers).mapToObj(Double::toString).collect(Collectors.joining(" "));
    }

    private static double[] numbers(String line) {
        return Arrays.stream(line.split(" ", -1))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }
}
