package org.robonewbie.learning.series;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What is done in each trial of a series. A class that implements it has a public constructor without parameters. Trials run
 * in many threads and on other computers, and again after a failure, so the result may depend on parameters and seed only.
 *
 * <pre>{@code
 * public class Nod implements Experiment {
 *     public List<String> columns() { return List.of("fallen"); }
 *
 *     public double[] run(Map<String, Double> parameters, long seed) {
 *         try (Trial trial = Trial.direct(Scene.of(RobotStart.at(0, 0)), seed, Controller.ofSpeeds())) {
 *             trial.run(5);
 *             return new double[] {trial.now().robot().isFallen() ? 1 : 0};
 *         }
 *     }
 * }
 * }</pre>
 */
public interface Experiment {

    /** {@return the names of the table's columns, with units: what a trial measures} */
    List<String> columns();

    /** {@return the names of the parameters that a plan may give; empty if it may give any} */
    default Optional<List<String>> parameters() {
        return Optional.empty();
    }

    /**
     * Carries out one trial.
     *
     * @param parameters the values of the plan for this trial
     * @param seed chooses all that is random in it
     * @return one number for each of the {@link #columns}
     * @throws Exception if the trial failed; it is tried again some times
     */
    double[] run(Map<String, Double> parameters, long seed) throws Exception;

    /**
     * Carries out one trial of a plan with parameters that are texts, such as the name of an agent.
     *
     * @param numbers the numbers of the plan for this trial
     * @param texts the texts of the plan for this trial
     * @param seed chooses all that is random in it
     * @return one number for each of the {@link #columns}
     * @throws Exception if the trial failed; it is tried again some times
     */
    default double[] run(Map<String, Double> numbers, Map<String, String> texts, long seed) throws Exception {
        if (!texts.isEmpty()) {
            throw new IllegalArgumentException("The plan gives texts (" + String.join(", ", texts.keySet())
                    + "), but this experiment takes numbers only. Let it override run(numbers, texts, seed).");
        }
        return run(numbers, seed);
    }

    /**
     * Creates an experiment from the name of its class.
     *
     * @param className full name of a class that the current thread's class loader knows
     * @return the experiment
     * @throws IllegalArgumentException if that is not an experiment; the message says what to do
     */
    static Experiment of(String className) {
        try {
            ClassLoader loader = Thread.currentThread().getContextClassLoader();
            return Class.forName(className, true, loader)
                    .asSubclass(Experiment.class)
                    .getConstructor()
                    .newInstance();
        } catch (ReflectiveOperationException | ClassCastException wrong) {
            throw new IllegalArgumentException(
                    className + " is not an experiment (" + wrong
                            + "). Give the full name of a public class that implements Experiment and has a public"
                            + " constructor without parameters, and its folder or jar with --class-path.",
                    wrong);
        }
    }
}
