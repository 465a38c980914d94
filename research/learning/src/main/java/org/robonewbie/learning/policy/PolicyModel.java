package org.robonewbie.learning.policy;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.DoubleStream;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.learning.environment.EnvironmentSpec;
import org.robonewbie.learning.environment.ObservedQuantity;
import org.robonewbie.learning.environment.TrainingEnvironment;
import org.robonewbie.learning.environment.TrainingTask;

/**
 * Mapping between the policies of a task and parameter vectors. A vector holds the parameters of a gait, if the task learns one, and the
 * weights of a network. By default, the inputs of the network are all components of the observation except the joint angles.
 *
 * <pre>{@code
 * PolicyModel model = new PolicyModel(new EnvironmentSpec("Stand", List.of()), PolicyModel.DEFAULT_INPUTS, 16, classes);
 * Policy untrained = model.policy(List.of(), model.initial(1));
 * }</pre>
 */
public final class PolicyModel {

    /** Default number of hidden neurons. */
    public static final int DEFAULT_HIDDEN = 16;

    /** Regular expression of all observed quantities except joint angles. */
    public static final String DEFAULT_INPUTS = "(?!joint\\.).*";

    /**
     * Scale of the bias of an output that follows a hidden layer. It is larger than the scale of a weight, because the
     * bias shifts the whole posture.
     */
    private static final double BIAS_SCALE = 4;

    private static final double GAIT_SCALE = 3;

    /**
     * Typical magnitude of an input, keyed by unit. For inputs with other units, the magnitude is half of their range.
     */
    private static final Map<String, Double> TYPICAL =
            Map.of("degrees", 30.0, "degrees/s", 100.0, "m/s²", 10.0, "N", 50.0, "1", 1.0);

    private final EnvironmentSpec spec;
    private final String inputPattern;
    private final int hidden;
    private final ClassLoader classes;
    private final TrainingTask task;
    private final List<ObservedQuantity> inputs;
    private final int[] layers;
    private final double[] gait;

    /**
     * Creates the model for a task with one learning robot.
     *
     * @param spec the task and its options
     * @param inputPattern regular expression for the names of the network's inputs, such as {@link #DEFAULT_INPUTS}
     * @param hidden the number of hidden neurons; 0 for a network without a hidden layer
     * @param classes the class loader for custom tasks
     * @throws IllegalArgumentException if there is no such task, option or input, or if several robots learn in the task
     */
    public PolicyModel(EnvironmentSpec spec, String inputPattern, int hidden, ClassLoader classes) {
        if (hidden < 0) {
            throw new IllegalArgumentException("--hidden must be at least 0, not " + hidden + ".");
        }
        this.spec = spec;
        this.inputPattern = inputPattern;
        this.hidden = hidden;
        this.classes = classes;
        try (TrainingEnvironment sample = open()) {
            task = sample.task();
            inputs = sample.quantities().stream()
                    .filter(quantity -> quantity.name().matches(inputPattern))
                    .toList();
        }
        if (inputs.isEmpty()) {
            throw new IllegalArgumentException(
                    "No observed quantity of " + task() + " has a name that matches " + inputPattern + ".");
        }
        if (task.learners() > 1) {
            throw new IllegalArgumentException(task() + " trains several robots; choose a task for a single robot.");
        }
        int outputs = task.outputs().size();
        layers = hidden == 0 ? new int[] {inputs.size(), outputs} : new int[] {inputs.size(), hidden, outputs};
        gait = task.learnsGait()
                ? task.walk().orElseThrow().numbers(PolicyWalk.GAIT, FastWalk.PARAMETERS)
                : new double[0];
    }

    /** {@return the name of the task} */
    public String task() {
        return spec.task();
    }

    /** Returns the options of {@code robonewbie learn} that create this model. */
    String commandLine() {
        StringBuilder line = new StringBuilder();
        if (!inputPattern.equals(DEFAULT_INPUTS)) {
            line.append(" --inputs '").append(inputPattern).append("'");
        }
        if (hidden != DEFAULT_HIDDEN) {
            line.append(" --hidden ").append(hidden);
        }
        spec.options().forEach(option -> line.append(" --option ").append(option));
        return line.toString();
    }

    TrainingEnvironment open() {
        return spec.create(classes);
    }

    /** Configures an environment for a policy, so that each action lasts as many cycles as in the policy's training. */
    void prepare(TrainingEnvironment environment, Policy policy) {
        environment.setOptions(spec.randomization().withDefaultCycles(policy.cyclesPerAction()));
    }

    /**
     * Draws the parameters of an untrained policy. The last layer is zero, so all outputs are zero.
     *
     * @param seed the seed for the weights of the hidden layer
     * @return the parameters
     */
    public double[] initial(long seed) {
        Random random = new Random(seed);
        random.nextLong();
        double[] initial = Arrays.copyOf(gait, size());
        double[] scale = scale();
        for (int i = gait.length; i < gait.length + hiddenSize(); i++) {
            initial[i] = scale[i] * random.nextGaussian() / Math.sqrt(layers[0]);
        }
        return initial;
    }

    private int size() {
        return gait.length + Network.size(layers);
    }

    private int hiddenSize() {
        return hidden == 0 ? 0 : Network.size(layers[0], hidden);
    }

    /**
     * Returns the parameters of a policy.
     *
     * @param policy the policy
     * @return the parameters
     * @throws IllegalArgumentException if the policy was learned for another task or its network differs from that of
     *     this model
     */
    public double[] initial(Policy policy) {
        policy.require(quantities(), task.outputs());
        List<String> trained = layerLines(policy);
        List<String> needed = layerLines(policy(List.of(), initial(0)));
        if (!trained.equals(needed)) {
            throw new IllegalArgumentException("The policy \"" + policy.task() + "\" has the layers " + trained
                    + " instead of " + needed + ". Pass the same --hidden value that it was trained with; a policy with"
                    + " other activation functions cannot be trained further here.");
        }
        double[] learnedGait = gait.length > 0 ? policy.numbers(PolicyWalk.GAIT, gait.length) : gait;
        return DoubleStream.concat(
                        DoubleStream.of(learnedGait),
                        DoubleStream.of(policy.network().numbers()))
                .toArray();
    }

    private static List<String> layerLines(Policy policy) {
        return PolicyText.format(policy)
                .lines()
                .filter(line -> line.startsWith("layer "))
                .toList();
    }

    /** {@return the scale of each parameter; that of a weight in the first layer is the inverse of its input's typical magnitude} */
    public double[] scale() {
        double[] scale = new double[size()];
        Arrays.fill(scale, 1);
        if (gait.length > 0) {
            Arrays.fill(scale, 0, gait.length, GAIT_SCALE);
            return scale;
        }
        for (int i = 0; i < layers[1]; i++) {
            for (int j = 0; j < inputs.size(); j++) {
                scale[i * (inputs.size() + 1) + 1 + j] = 1 / typical(inputs.get(j));
            }
        }
        for (int i = hiddenSize(); i < scale.length && hidden > 0; i += hidden + 1) {
            scale[i] = BIAS_SCALE;
        }
        return scale;
    }

    private static double typical(ObservedQuantity quantity) {
        return TYPICAL.getOrDefault(quantity.unit(), (quantity.greatest() - quantity.least()) / 2);
    }

    private List<Quantity> quantities() {
        return inputs.stream()
                .map(input -> new Quantity(input.name(), input.unit()))
                .toList();
    }

    /**
     * Creates a policy.
     *
     * @param about comments for the policy's file that describe how the policy was learned
     * @param parameters the parameters of the policy
     * @return the policy
     */
    public Policy policy(List<String> about, double... parameters) {
        Map<String, List<Double>> others =
                new TreeMap<>(task.walk().map(Policy::numbers).orElse(Map.of()));
        if (gait.length > 0) {
            others.put(
                    PolicyWalk.GAIT,
                    Arrays.stream(parameters).limit(gait.length).boxed().toList());
        }
        int cycles = spec.randomization()
                .withDefaultCycles(task.cyclesPerAction())
                .draw(0)
                .cycles();
        if (cycles > 1) {
            others.put(Policy.CYCLES_PER_ACTION, List.of((double) cycles));
        }
        task.motion().ifPresent(motion -> others.put(MotionGuide.MOTION, MotionGuide.numbers(motion)));
        Network network = Network.of(layers, Arrays.copyOfRange(parameters, gait.length, parameters.length));
        return new Policy(task(), about, others, quantities(), task.outputs(), network);
    }
}
