package org.robonewbie.learning.series;

import java.io.Serializable;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One line of the table that is still to be measured.
 *
 * @param number its number, from 0
 * @param seed chooses all that is random in it
 * @param parameters the numbers that the plan says for it, in the order of the plan
 * @param texts the texts that the plan says for it, in the order of the plan
 */
public record PlannedTrial(
        int number, long seed, LinkedHashMap<String, Double> parameters, LinkedHashMap<String, String> texts)
        implements Serializable {

    private static final int MOST_ATTEMPTS = 3;

    /** Copies the parameters. */
    public PlannedTrial {
        parameters = new LinkedHashMap<>(parameters);
        texts = new LinkedHashMap<>(texts);
    }

    /**
     * Plans a trial whose parameters are numbers.
     *
     * @param number its number, from 0
     * @param seed chooses all that is random in it
     * @param parameters what the plan says for it
     */
    public PlannedTrial(int number, long seed, LinkedHashMap<String, Double> parameters) {
        this(number, seed, parameters, new LinkedHashMap<>());
    }

    /** {@return numbers and texts of the plan by name, in the order in which the table has them} */
    LinkedHashMap<String, Object> all() {
        LinkedHashMap<String, Object> all = new LinkedHashMap<>(parameters);
        all.putAll(texts);
        return all;
    }

    /**
     * Carries the trial out; a trial that fails is tried again.
     *
     * @param experiment what to do
     * @return the measured numbers
     * @throws IllegalStateException if it failed three times; the message names the trial
     */
    public double[] run(Experiment experiment) {
        for (int attempt = 1; ; attempt++) {
            try {
                return checked(experiment);
            } catch (Exception failure) {
                if (attempt == MOST_ATTEMPTS) {
                    throw new IllegalStateException(
                            "Trial " + number + " (seed " + seed + ", " + all() + ") failed " + attempt + " times: "
                                    + failure,
                            failure);
                }
            }
        }
    }

    private double[] checked(Experiment experiment) throws Exception {
        double[] measured = experiment.run(Map.copyOf(parameters), Map.copyOf(texts), seed);
        if (measured.length != experiment.columns().size()) {
            throw new IllegalStateException("it gave " + measured.length + " numbers for "
                    + experiment.columns().size() + " columns");
        }
        return measured;
    }
}
