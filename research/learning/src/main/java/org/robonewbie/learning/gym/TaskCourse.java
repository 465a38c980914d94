package org.robonewbie.learning.gym;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.learning.policy.Classroom;
import org.robonewbie.learning.policy.Course;
import org.robonewbie.learning.policy.TrainingPlan;

/**
 * A task as something to learn by trying: episodes are the lessons, and what is changed are the weights of a network. It takes what
 * the robot feels, usually without the angles of its joints, how far the task's motion has got, and what is wanted.
 *
 * <pre>{@code
 * Course course = TaskCourse.of("Stand", TaskCourse.USUAL_INPUTS, 16, getClass().getClassLoader());
 * }</pre>
 */
public final class TaskCourse implements Course {

    /** How many hidden neurons a network has unless another number is wanted. */
    public static final int USUAL_HIDDEN = 16;

    /** Behind a hidden layer an output's bias, which changes the posture as a whole, is moved by the multiple of a weight. */
    private static final double BIAS_UNIT = 4;

    /** What a network takes unless something else is wanted: all but the angles of the joints. */
    public static final String USUAL_INPUTS = "(?!joint\\.).*";

    private static final String RANGE = "range-degrees";

    /** The usual size of what goes into the first layer, by its unit; half the range of what is not listed. */
    private static final Map<String, Double> USUAL =
            Map.of("degrees", 30.0, "degrees/s", 100.0, "m/s²", 10.0, "N", 50.0, "1", 1.0);

    private final String task;
    private final String wanted;
    private final int hidden;
    private final ClassLoader classes;
    private final GymTask model;
    private final List<ObservedQuantity> inputs;
    private final int[] layers;

    private TaskCourse(String task, String wanted, int hidden, ClassLoader classes) {
        this.task = task;
        this.wanted = wanted;
        this.hidden = hidden;
        this.classes = classes;
        try (GymEnvironment sample = environment(GymOptions.NONE)) {
            model = sample.task();
            inputs = sample.quantities().stream()
                    .filter(quantity -> quantity.name().matches(wanted))
                    .toList();
        }
        int outputs = model.joints().size();
        layers = hidden == 0 ? new int[] {inputs.size(), outputs} : new int[] {inputs.size(), hidden, outputs};
    }

    /**
     * Looks a task up.
     *
     * @param task its name, such as {@code Stand}, or the name of a class that extends {@link GymTask}
     * @param inputs a regular expression for the names of what the network takes, such as {@link #USUAL_INPUTS}
     * @param hidden how many hidden neurons there are; 0 for a network without a hidden layer
     * @param classes where to look for the class
     * @return the course
     * @throws IllegalArgumentException if there is none, if hidden is negative, if several robots learn in it, or if nothing is called like the inputs
     */
    public static TaskCourse of(String task, String inputs, int hidden, ClassLoader classes) {
        if (hidden < 0) {
            throw new IllegalArgumentException(hidden + " hidden neurons: give a number from 0.");
        }
        TaskCourse course = new TaskCourse(task, inputs, hidden, classes);
        if (course.inputs.isEmpty()) {
            throw new IllegalArgumentException(
                    "Nothing that is observed in " + task + " has a name like " + inputs + ".");
        }
        if (course.model.learners() > 1) {
            throw new IllegalArgumentException("In " + task + " several robots learn; choose a task for one.");
        }
        return course;
    }

    private GymEnvironment environment(GymOptions options) {
        return new GymEnvironment(new GymOrder(task, "").episodes(classes), options);
    }

    @Override
    public String task() {
        return task;
    }

    @Override
    public String words(TrainingPlan plan) {
        StringBuilder words = new StringBuilder(plan.words());
        if (!wanted.equals(USUAL_INPUTS)) {
            words.append(" --inputs '").append(wanted).append("'");
        }
        if (hidden != USUAL_HIDDEN) {
            words.append(" --hidden ").append(hidden);
        }
        plan.options().forEach(option -> words.append(" --option ").append(option));
        return words.toString();
    }

    /** {@inheritDoc} The last layer begins with zeros, so that nothing is corrected yet. */
    @Override
    public double[] start(long seed) {
        Random random = new Random(seed);
        random.nextLong();
        double[] start = new double[Network.size(layers)];
        double[] units = units();
        for (int i = 0; i < sizeOfHidden(); i++) {
            start[i] = units[i] * random.nextGaussian() / Math.sqrt(layers[0]);
        }
        return start;
    }

    /** How many numbers the hidden layer has. */
    private int sizeOfHidden() {
        return hidden == 0 ? 0 : Network.size(layers[0], hidden);
    }

    @Override
    public double[] start(Policy policy) {
        policy.require(inputs(), model.outputs());
        double[] numbers = policy.network().numbers();
        if (numbers.length != Network.size(layers)) {
            throw new IllegalArgumentException("The policy \"" + policy.task() + "\" has " + numbers.length
                    + " numbers where " + Network.size(layers) + " are needed. Was it learned in another way?");
        }
        return numbers;
    }

    /** {@inheritDoc} A weight of the first layer is moved the less the larger its input usually is. */
    @Override
    public double[] units() {
        double[] units = new double[Network.size(layers)];
        Arrays.fill(units, 1);
        for (int i = 0; i < layers[1]; i++) {
            for (int j = 0; j < inputs.size(); j++) {
                units[i * (inputs.size() + 1) + 1 + j] = 1 / usual(inputs.get(j));
            }
        }
        for (int i = sizeOfHidden(); i < units.length && hidden > 0; i += hidden + 1) {
            units[i] = BIAS_UNIT;
        }
        return units;
    }

    private static double usual(ObservedQuantity quantity) {
        return USUAL.getOrDefault(quantity.unit(), (quantity.greatest() - quantity.least()) / 2);
    }

    private List<Quantity> inputs() {
        return inputs.stream()
                .map(input -> new Quantity(input.name(), input.unit()))
                .toList();
    }

    @Override
    public Policy policy(List<String> about, double... numbers) {
        return policy(1, about, numbers);
    }

    @Override
    public Policy policy(TrainingPlan plan, List<String> about, double... numbers) {
        return policy(options(plan).draw(plan.seed()).cycles(), about, numbers);
    }

    private Policy policy(int cyclesPerAction, List<String> about, double... numbers) {
        Map<String, List<Double>> others =
                new TreeMap<>(model.walk().map(Policy::numbers).orElse(Map.of()));
        others.put(RANGE, List.of(model.rangeDegrees()));
        if (cyclesPerAction > 1) {
            others.put(Policy.CYCLES_PER_ACTION, List.of((double) cyclesPerAction));
        }
        model.motion().ifPresent(motion -> others.put(MotionGuide.MOTION, MotionGuide.numbers(motion)));
        return new Policy(task, about, others, inputs(), model.outputs(), Network.of(layers, numbers));
    }

    private static GymOptions options(TrainingPlan plan) {
        return GymOrder.options(plan.options().stream());
    }

    @Override
    public Classroom open(TrainingPlan plan) {
        GymOptions options = options(plan);
        return new TaskClassroom(environment(options), options, this);
    }
}
