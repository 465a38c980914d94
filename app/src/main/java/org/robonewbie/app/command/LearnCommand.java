package org.robonewbie.app.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.learning.environment.EnvironmentSpec;
import org.robonewbie.learning.policy.EvolutionStrategy;
import org.robonewbie.learning.policy.PolicyModel;
import org.robonewbie.learning.policy.PolicySearch;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ProgramFinder;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Command that trains a policy for a task with an evolution strategy, or evaluates one. */
@Command(
        name = LearnCommand.NAME,
        description = {
            "Train a policy for a task with an evolution strategy, or evaluate a policy.",
            "",
            "Each generation writes the policy to FILE, the learning curve to FILE.csv and a checkpoint to FILE.checkpoint."
                    + " To resume an interrupted search, run the same command again."
                    + " docs/policies.md explains the method and its results."
        },
        sortOptions = false,
        footer = {
            "",
            "Examples:",
            "  robonewbie learn WalkGait                      trains a walk and writes WalkGait.policy",
            "  robonewbie learn WalkGait better.policy --start shipped --sigma 0.02 --learning-rate 0.003",
            "  robonewbie learn Stand --option noise=0.3      a task of the Python package, or a custom class",
            "  robonewbie learn Stand --evaluate 100          evaluates Stand.policy",
            "  robonewbie learn Stand shipped --evaluate 100  evaluates the shipped policy",
            "  robonewbie learn Stand none --evaluate 100     evaluates an untrained policy"
        })
final class LearnCommand implements Callable<Integer> {

    static final String NAME = "learn";

    private static final String SHIPPED = "shipped";
    private static final String NONE = "none";

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(index = "0", paramLabel = "TASK", description = "One of the tasks listed below, or a custom class.")
    private String task = "";

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "FILE",
            description = "Policy file (default: TASK.policy); with --evaluate, also \"shipped\" or \"none\".")
    private @Nullable String file;

    @Option(names = "--generations", paramLabel = "N", description = "Number of generations (default: 500).")
    private int generations = 500;

    @Option(
            names = "--pairs",
            paramLabel = "N",
            description = "Antithetic pairs of candidates per generation (default: 16).")
    private int pairs = 16;

    @Option(names = "--sigma", paramLabel = "X", description = "Standard deviation of the candidates (default: 0.05).")
    private double sigma = 0.05;

    @Option(
            names = "--learning-rate",
            paramLabel = "X",
            description = "Step size of the mean per generation (default: 0.01).")
    private double learningRate = 0.01;

    @Option(
            names = "--option",
            paramLabel = "NAME=VALUE",
            description = "Task option listed below, such as noise=0.5 or push=10..20.")
    private List<String> options = List.of();

    @Option(
            names = "--inputs",
            paramLabel = "REGEX",
            description = "Pattern for the names of the network's inputs (default: all observed quantities except joint"
                    + " angles).")
    private String inputs = PolicyModel.DEFAULT_INPUTS;

    @Option(
            names = "--hidden",
            paramLabel = "N",
            description = "Number of hidden neurons; 0 for no hidden layer (default: 16).")
    private int hidden = PolicyModel.DEFAULT_HIDDEN;

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    @Option(
            names = "--seed",
            paramLabel = "S",
            description = "Random seed; the same seed gives the same policy, or with --evaluate the same episodes"
                    + " (default: 1).")
    private long seed = 1;

    @Option(
            names = "--start",
            paramLabel = "POLICY",
            description = "Initial policy of a new search: a file, or \"shipped\".")
    private @Nullable String start;

    @Option(
            names = "--evaluate",
            paramLabel = "EPISODES",
            description = "Evaluate the policy over this many episodes instead of training.")
    private @Nullable Integer evaluate;

    /** Returns the rules of the tasks for one robot, for the help text. */
    static Map<String, String> rules() {
        Map<String, String> rules = new TreeMap<>();
        EnvironmentSpec.tasks().forEach((name, task) -> {
            if (task.learners() == 1) {
                rules.put(name, "Reward: " + task.rewardRule() + ". Success: " + task.successRule() + ".");
            }
        });
        return rules;
    }

    @Override
    public Integer call() throws IOException {
        try {
            EnvironmentSpec spec = new EnvironmentSpec(task, options);
            PolicyModel model = new PolicyModel(spec, inputs, hidden, ProgramFinder.loaderOf(classPath.folders()));
            String policy = file == null ? task + ".policy" : file;
            if (evaluate == null) {
                learn(model, policy);
            } else if (evaluate > 0) {
                System.out.println(policy + ": " + PolicySearch.evaluate(model, evaluate, seed, policy(model, policy)));
            } else {
                throw new CalledWronglyException("--evaluate must be at least 1, not " + evaluate + ".");
            }
            return ExitCode.OK;
        } catch (IllegalArgumentException | UncheckedIOException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        }
    }

    private void learn(PolicyModel model, String name) throws IOException {
        if (SHIPPED.equals(name) || NONE.equals(name)) {
            throw new CalledWronglyException(
                    "\"" + name + "\" cannot be overwritten. Add --evaluate EPISODES to evaluate it.");
        }
        Path output = Path.of(name);
        EvolutionStrategy strategy = new EvolutionStrategy(seed, pairs, sigma, learningRate);
        PolicySearch search = new PolicySearch(model, strategy, output);
        search.run(generations, Optional.ofNullable(start).map(from -> policy(model, from)), System.out::println);
        System.out.println("Wrote the policy to " + output + " and the learning curve to " + search.curve() + ".");
    }

    private static Policy policy(PolicyModel model, String name) {
        return switch (name) {
            case SHIPPED -> PolicyFile.shipped(shippedName(model.task()));
            case NONE -> model.policy(List.of(), model.initial(0));
            default -> PolicyFile.read(Path.of(name));
        };
    }

    /**
     * Returns the name of a task's shipped policy: {@code get-up} for {@code QuickGetUp}, {@code walk} for {@code
     * WalkGait}.
     */
    private static String shippedName(String task) {
        return task.replaceFirst("^Quick(?=[A-Z])|Gait$", "")
                .replaceAll("(?<=[a-z])(?=[A-Z])", "-")
                .toLowerCase(Locale.ROOT);
    }
}
