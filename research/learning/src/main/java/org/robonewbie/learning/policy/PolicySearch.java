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
import org.robonewbie.trial.batch.Journal;

/**
 * Searches for a policy by an {@link EvolutionStrategy}. After each generation it writes the policy so far, a line of the learning
 * curve as CSV, and a checkpoint from which an interrupted search continues with the same result.
 *
 * <pre>{@code
 * PolicySearch search = new PolicySearch(model, new EvolutionStrategy(1, 16, 0.05, 0.01), Path.of("Stand.policy"));
 * Policy learned = search.run(500, Optional.empty(), System.out::println);
 * }</pre>
 *
 * @param model the numbers that are searched
 * @param strategy how they are searched
 * @param output file of the policy; curve and checkpoint are written beside it
 */
public record PolicySearch(PolicyModel model, EvolutionStrategy strategy, Path output) {

    /** {@return the learning curve, a CSV file beside the policy} */
    public Path curve() {
        return beside(".csv");
    }

    /** {@return the checkpoint, a file beside the policy} */
    public Path checkpoint() {
        return beside(".checkpoint");
    }

    private Path beside(String ending) {
        return output.resolveSibling(output.getFileName() + ending);
    }

    /**
     * Plays episodes that no search has seen.
     *
     * @param model the task
     * @param episodes number of episodes
     * @param policy what acts in them
     * @return the result
     * @throws IOException if an episode cannot be played
     * @throws IllegalArgumentException if the policy was learned for another task
     */
    public static RolloutStatistics evaluate(PolicyModel model, int episodes, Policy policy) throws IOException {
        try (RolloutWorkers workers = new RolloutWorkers(model)) {
            return workers.play(episodes, i -> policy, i -> -1L - i);
        }
    }

    /**
     * Searches until there were so many generations. It continues from the checkpoint if there is one.
     *
     * @param generations number of generations, those before an interruption included
     * @param start the policy from which a new search starts; empty for one that has learned nothing
     * @param progress gets a line after each generation
     * @return what was learned
     * @throws IOException if a file cannot be read or written
     * @throws IllegalArgumentException if the checkpoint belongs to another search or is damaged
     */
    public Policy run(int generations, Optional<Policy> start, Consumer<String> progress) throws IOException {
        try (Journal journal = Journal.open(checkpoint(), question());
                RolloutWorkers workers = new RolloutWorkers(model)) {
            boolean resumes = !journal.lines().isEmpty();
            List<String> history = resumes ? former() : start.map(Policy::about).orElse(List.of());
            EvolutionStrategy.State state = resumes ? replayed(journal.lines()) : begin(start);
            if (!resumes) {
                journal.add(line(state.mean()));
            }
            beginCurve(state.generation());
            while (state.generation() < generations) {
                RolloutStatistics result = generation(workers, state);
                double[] returns =
                        result.rollouts().stream().mapToDouble(Rollout::reward).toArray();
                state = strategy.tell(state, returns);
                keep(state, history, result);
                journal.add(line(returns));
                progress.accept(String.format(Locale.ROOT, "%4d/%d: %s", state.generation(), generations, result));
            }
            return policy(state, history);
        }
    }

    private EvolutionStrategy.State begin(Optional<Policy> start) {
        double[] mean = start.map(model::initial).orElseGet(() -> model.initial(strategy.seed()));
        return EvolutionStrategy.State.begin(mean, model.scale());
    }

    /** How the policy was learned with which an interrupted search began; the last line is that of the search. */
    private List<String> former() {
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

    /** Keeps the lines of known generations: an interrupted search may have written one more. */
    private void beginCurve(int generations) throws IOException {
        Stream<String> lines = generations == 0 ? Stream.empty() : Files.readAllLines(curve()).stream();
        AtomicFile.write(
                curve(),
                Stream.concat(
                                Stream.of("generation," + RolloutStatistics.COLUMNS),
                                lines.skip(1).limit(generations))
                        .collect(Collectors.joining("\n", "", "\n")));
    }

    private void keep(EvolutionStrategy.State state, List<String> history, RolloutStatistics result)
            throws IOException {
        String line = state.generation() + "," + result.row() + "\n";
        Files.writeString(curve(), line, StandardCharsets.UTF_8, StandardOpenOption.APPEND);
        AtomicFile.write(output, PolicyText.format(policy(state, history)));
    }

    private Policy policy(EvolutionStrategy.State state, List<String> history) {
        String last = "learned by: robonewbie learn " + question() + " --generations " + state.generation();
        return model.policy(Stream.concat(history.stream(), Stream.of(last)).toList(), state.mean());
    }

    /** Everything that the result depends on but the number of generations. */
    private String question() {
        return model.task() + " " + strategy.words() + model.words();
    }

    /** The state after the generations of the checkpoint: its first line is the initial mean, the others are returns. */
    private EvolutionStrategy.State replayed(List<String> lines) {
        try {
            EvolutionStrategy.State state = EvolutionStrategy.State.begin(numbers(lines.get(0)), model.scale());
            for (String returns : lines.subList(1, lines.size())) {
                state = strategy.tell(state, numbers(returns));
            }
            return state;
        } catch (IndexOutOfBoundsException | NumberFormatException damaged) {
            throw new IllegalArgumentException(checkpoint() + " is damaged: delete it to begin again.", damaged);
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
