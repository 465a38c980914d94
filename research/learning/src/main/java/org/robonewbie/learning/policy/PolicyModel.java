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
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.learning.environment.EnvironmentSpec;
import org.robonewbie.learning.environment.ObservedQuantity;
import org.robonewbie.learning.environment.TrainingEnvironment;
import org.robonewbie.learning.environment.TrainingTask;

/**
 * Policies of one task as vectors of numbers: the weights of a network, and before them the numbers of a gait if the task learns one. The
 * network takes what the robot senses, usually without joint angles, the progress of the task's motion, and the command.
 *
 * <pre>{@code
 * PolicyModel model = new PolicyModel(new EnvironmentSpec("Stand", List.of()), PolicyModel.DEFAULT_INPUTS, 16, classes);
 * Policy nothing = model.policy(List.of(), model.initial(1));
 * }</pre>
 */
public final class PolicyModel {

    /** Number of hidden neurons. */
    public static final int DEFAULT_HIDDEN = 16;

    /** All observed quantities but the angles of the joints. */
    public static final String DEFAULT_INPUTS = "(?!joint\\.).*";

    /** Scale of an output's bias, which changes the posture as a whole, behind a hidden layer. */
    private static final double BIAS_SCALE = 4;

    private static final double GAIT_SCALE = 3;
    private static final String RANGE = "range-degrees";

    /** Typical inputs of the first layer by their unit; half the range of what is not listed. */
    private static final Map<String, Double> TYPICAL =
            Map.of("degrees", 30.0, "degrees/s", 100.0, "m/s²", 10.0, "N", 50.0, "1", 1.0);

    private final EnvironmentSpec spec;
    private final String wanted;
    private final int hidden;
    private final ClassLoader classes;
    private final TrainingTask task;
    private final List<ObservedQuantity> inputs;
    private final int[] layers;
    private final double[] gait;

    /**
     * Creates the model of a task for one robot.
     *
     * @param spec the task and its options
     * @param inputs a regular expression for the names of what the network takes, such as {@link #DEFAULT_INPUTS}
     * @param hidden number of hidden neurons; 0 for a network without a hidden layer
     * @param classes where to look for the class of a task
     * @throws IllegalArgumentException if there is no such task, option or input, or if several robots learn in it
     */
    public PolicyModel(EnvironmentSpec spec, String inputs, int hidden, ClassLoader classes) {
        if (hidden < 0) {
            throw new IllegalArgumentException(hidden + " hidden neurons: give a number from 0.");
        }
        this.spec = spec;
        this.wanted = inputs;
        this.hidden = hidden;
        this.classes = classes;
        try (TrainingEnvironment sample = open()) {
            task = sample.task();
            this.inputs = sample.quantities().stream()
                    .filter(quantity -> quantity.name().matches(inputs))
                    .toList();
        }
        if (this.inputs.isEmpty()) {
            throw new IllegalArgumentException(
                    "Nothing that is observed in " + task() + " has a name like " + inputs + ".");
        }
        if (task.learners() > 1) {
            throw new IllegalArgumentException("In " + task() + " several robots learn; choose a task for one.");
        }
        int outputs = task.outputs().size();
        layers =
                hidden == 0 ? new int[] {this.inputs.size(), outputs} : new int[] {this.inputs.size(), hidden, outputs};
        gait = task.learnsGait()
                ? task.walk().orElseThrow().numbers(PolicyWalk.GAIT, FastWalk.PARAMETERS)
                : new double[0];
    }

    /** {@return the name of the task} */
    public String task() {
        return spec.task();
    }

    /** The options of {@code robonewbie learn} that make this model. */
    String words() {
        StringBuilder words = new StringBuilder();
        if (!wanted.equals(DEFAULT_INPUTS)) {
            words.append(" --inputs '").append(wanted).append("'");
        }
        if (hidden != DEFAULT_HIDDEN) {
            words.append(" --hidden ").append(hidden);
        }
        spec.options().forEach(option -> words.append(" --option ").append(option));
        return words.toString();
    }

    /** Creates an environment of the task. */
    TrainingEnvironment open() {
        return spec.create(classes);
    }

    /** Prepares an environment for the next episodes of a policy: its actions last as long as while it was learned. */
    void prepare(TrainingEnvironment environment, Policy policy) {
        environment.setOptions(spec.randomization().withDefaultCycles(policy.cyclesPerAction()));
    }

    /**
     * Draws the numbers of a policy that has learned nothing. The last layer has zeros, so that nothing is corrected yet.
     *
     * @param seed chooses the weights of the hidden layer
     * @return the numbers
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
     * Takes the numbers of a policy.
     *
     * @param policy what was learned before
     * @return the numbers
     * @throws IllegalArgumentException if it was learned for another task, or with another network
     */
    public double[] initial(Policy policy) {
        policy.require(quantities(), task.outputs());
        double[] weights = policy.network().numbers();
        if (weights.length != Network.size(layers)) {
            throw new IllegalArgumentException("The policy \"" + policy.task() + "\" has " + weights.length
                    + " numbers where " + Network.size(layers) + " are needed. Was it learned in another way?");
        }
        double[] former = gait.length > 0 ? policy.numbers(PolicyWalk.GAIT, gait.length) : gait;
        return DoubleStream.concat(DoubleStream.of(former), DoubleStream.of(weights))
                .toArray();
    }

    /** {@return the scale of each number; a weight of the first layer has the smaller scale the larger its input typically is} */
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
     * Makes a policy.
     *
     * @param about how it was learned, for readers
     * @param numbers its numbers
     * @return the policy
     */
    public Policy policy(List<String> about, double... numbers) {
        Map<String, List<Double>> others =
                new TreeMap<>(task.walk().map(Policy::numbers).orElse(Map.of()));
        others.put(RANGE, List.of(task.rangeDegrees()));
        if (gait.length > 0) {
            others.put(
                    PolicyWalk.GAIT,
                    Arrays.stream(numbers).limit(gait.length).boxed().toList());
        }
        int cycles = spec.randomization().cycles();
        if (cycles > 1) {
            others.put(Policy.CYCLES_PER_ACTION, List.of((double) cycles));
        }
        task.motion().ifPresent(motion -> others.put(MotionGuide.MOTION, MotionGuide.numbers(motion)));
        Network network = Network.of(layers, Arrays.copyOfRange(numbers, gait.length, numbers.length));
        return new Policy(task(), about, others, quantities(), task.outputs(), network);
    }
}
