package org.robonewbie.learning.series;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.trial.measure.Catalogue;

/**
 * Experiment whose trials form a series. An implementation must have a public no-arg constructor. Trials may run in parallel or on other
 * computers, and may be repeated after a failure, so the result must depend only on the parameters and the seed.
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

    /** {@return the names of the measured values, with units} */
    List<String> columns();

    /** {@return the names of the parameters that a plan may contain; empty, the default, for any} */
    default Optional<List<String>> parameters() {
        return Optional.empty();
    }

    /**
     * Runs one trial.
     *
     * @param parameters the parameters of the trial
     * @param seed the seed of the trial
     * @return a value for each of the {@link #columns}
     * @throws Exception if the trial failed; a failed trial is attempted up to three times
     */
    double[] run(Map<String, Double> parameters, long seed) throws Exception;

    /**
     * Runs one trial of a plan with text parameters, such as the name of an agent. By default, text parameters are
     * rejected.
     *
     * @param numbers the numeric parameters of the trial
     * @param texts the text parameters of the trial
     * @param seed the seed of the trial
     * @return a value for each of the {@link #columns}
     * @throws Exception if the trial failed; a failed trial is attempted up to three times
     */
    default double[] run(Map<String, Double> numbers, Map<String, String> texts, long seed) throws Exception {
        if (!texts.isEmpty()) {
            throw new IllegalArgumentException("The plan has text parameters (" + String.join(", ", texts.keySet())
                    + "), but this experiment takes numbers only. Override run(numbers, texts, seed) to accept texts.");
        }
        return run(numbers, seed);
    }

    /**
     * Creates an experiment from the name of its class.
     *
     * @param className full name of a class that the context class loader of the thread can load
     * @return the experiment
     * @throws IllegalArgumentException if the class is not an experiment
     */
    static Experiment of(String className) {
        ClassLoader classes = Thread.currentThread().getContextClassLoader();
        return new Catalogue<>("experiment", Experiment.class)
                .named(className, classes)
                .get();
    }
}
