package org.robonewbie.learning.series;

import java.io.Serializable;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One trial of a plan.
 *
 * @param number the zero-based number of the trial
 * @param seed the seed of the trial
 * @param parameters the numeric parameters, in the order of the plan
 * @param texts the text parameters, in the order of the plan
 */
public record PlannedTrial(
        int number, long seed, LinkedHashMap<String, Double> parameters, LinkedHashMap<String, String> texts)
        implements Serializable {

    private static final int MAX_ATTEMPTS = 3;

    /** Stores unmodifiable copies of the parameters. */
    public PlannedTrial {
        parameters = new LinkedHashMap<>(parameters);
        texts = new LinkedHashMap<>(texts);
    }

    /** Returns all parameters, in the order of the table's columns. */
    LinkedHashMap<String, Object> all() {
        LinkedHashMap<String, Object> all = new LinkedHashMap<>(parameters);
        all.putAll(texts);
        return all;
    }

    /** Runs the trial, retrying if it fails. */
    ExperimentRun.Outcome run(Experiment experiment) {
        for (int attempt = 1; ; attempt++) {
            try {
                return new ExperimentRun.Outcome(checked(experiment), "");
            } catch (Exception failure) {
                if (attempt == MAX_ATTEMPTS) {
                    return new ExperimentRun.Outcome(
                            new double[0],
                            "Trial " + number + " (seed " + seed + ", " + all() + ") failed " + attempt + " times: "
                                    + failure);
                }
            }
        }
    }

    private double[] checked(Experiment experiment) throws Exception {
        double[] measured = experiment.run(Map.copyOf(parameters), Map.copyOf(texts), seed);
        if (measured.length != experiment.columns().size()) {
            throw new IllegalStateException("run() returned " + measured.length + " values for "
                    + experiment.columns().size() + " columns");
        }
        return measured;
    }
}
