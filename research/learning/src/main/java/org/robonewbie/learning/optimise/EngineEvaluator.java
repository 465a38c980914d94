package org.robonewbie.learning.optimise;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.learning.series.CollectedTrials;
import org.robonewbie.learning.series.ExperimentEngine;
import org.robonewbie.learning.series.PlannedTrial;

/** Lets an engine of experiments carry out the trials, such as a cluster. */
final class EngineEvaluator implements Evaluator {

    private final ExperimentEngine engine;
    private final String master;
    private final LinkedHashMap<String, String> recipe;

    EngineEvaluator(Subject subject, ExperimentEngine engine, String master) {
        this.engine = engine;
        this.master = master;
        this.recipe = new LinkedHashMap<>(subject.recipe());
    }

    @Override
    public List<Evaluation> all(List<double[]> candidates, List<Long> seeds) {
        List<PlannedTrial> planned = new ArrayList<>();
        for (double[] candidate : candidates) {
            var coordinates = new LinkedHashMap<>(numbers(candidate));
            seeds.forEach(seed -> planned.add(new PlannedTrial(planned.size(), seed, coordinates, recipe)));
        }
        CollectedTrials results = new CollectedTrials();
        engine.run(CandidateExperiment.class.getName(), planned, master, done -> {}, results);
        return results.of(planned).stream()
                .map(numbers -> new Evaluation(numbers[0], numbers[1], numbers[2]))
                .toList();
    }

    private static Map<String, Double> numbers(double[] candidate) {
        Map<String, Double> coordinates = new LinkedHashMap<>();
        for (int i = 0; i < candidate.length; i++) {
            coordinates.put(CandidateExperiment.coordinate(i), candidate[i]);
        }
        return coordinates;
    }

    @Override
    public void close() {
        engine.close();
    }
}
