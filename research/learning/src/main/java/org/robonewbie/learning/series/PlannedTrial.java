package org.robonewbie.learning.series;

import java.io.Serializable;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One trial of a plan: a line of the table.
 *
 * @param number its number, from 0
 * @param seed chooses all that is random in it
 * @param parameters the numbers that the plan says for it, in the order of the plan
 * @param texts the texts that the plan says for it, in the order of the plan
 */
public record PlannedTrial(
        int number, long seed, LinkedHashMap<String, Double> parameters, LinkedHashMap<String, String> texts)
        implements Serializable {

    private static final int MAX_ATTEMPTS = 3;

    /** Copies the parameters. */
    public PlannedTrial {
        parameters = new LinkedHashMap<>(parameters);
        texts = new LinkedHashMap<>(texts);
    }

    /** {@return numbers and texts of the plan by name, in the order in which the table has them} */
    LinkedHashMap<String, Object> all() {
        LinkedHashMap<String, Object> all = new LinkedHashMap<>(parameters);
        all.putAll(texts);
        return all;
    }

    /** Runs the trial; a trial that fails is tried again. */
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
            throw new IllegalStateException("it gave " + measured.length + " numbers for "
                    + experiment.columns().size() + " columns");
        }
        return measured;
    }
}
